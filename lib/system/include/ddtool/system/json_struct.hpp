#pragma once

#include "ddtool/system/settings.hpp"

/// JSON conversions of a settings struct, its members named once. NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE would do, but
/// knows the unordered json only. To be used in the struct's namespace.
#define DDTOOL_JSON_STRUCT(Type, ...)                                                   \
    inline void to_json(ddtool::Json& nlohmann_json_j, const Type& nlohmann_json_t) {   \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))        \
    }                                                                                   \
    inline void from_json(const ddtool::Json& nlohmann_json_j, Type& nlohmann_json_t) { \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_FROM, __VA_ARGS__))      \
    }

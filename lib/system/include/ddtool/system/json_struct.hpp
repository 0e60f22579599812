#pragma once

#include "ddtool/system/settings.hpp"

/// Defines the JSON conversions of a settings struct from the names of its members. (NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE
/// does the same, but only for the JSON type whose keys are not kept in order.) Use it in the namespace of the struct.
#define DDTOOL_JSON_STRUCT(Type, ...)                                                   \
    inline void to_json(ddtool::Json& nlohmann_json_j, const Type& nlohmann_json_t) {   \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_TO, __VA_ARGS__))        \
    }                                                                                   \
    inline void from_json(const ddtool::Json& nlohmann_json_j, Type& nlohmann_json_t) { \
        NLOHMANN_JSON_EXPAND(NLOHMANN_JSON_PASTE(NLOHMANN_JSON_FROM, __VA_ARGS__))      \
    }

#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"

namespace ddtool {

/// The seeds of {"first": F, "count": N}: F, F + 1 and so on. Throws UsageError naming `where` unless there are 1 to a
/// million.
std::vector<std::uint64_t> seeds_from_json(const Json& json, const std::string& where);

}  // namespace ddtool

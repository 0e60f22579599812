#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "system/setting_rows.hpp"

namespace ddtool {

/// The descriptions of the settings "first" and "count".
const std::vector<Setting>& seed_range_setting_list();

/// The seeds of {"first": F, "count": N}: F, F + 1, ..., F + N - 1. Throws UsageError naming `where` unless N is
/// between one and a million.
std::vector<std::uint64_t> seeds_from_json(const Json& json, const std::string& where);

}  // namespace ddtool

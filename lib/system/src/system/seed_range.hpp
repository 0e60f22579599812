#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "system/setting_rows.hpp"

namespace ddtool {

/// What is known of "first" and "count".
const std::vector<Setting>& seed_range_setting_list();

/// The seeds of {"first": F, "count": N}: F, F + 1 and so on. Throws UsageError naming `where` unless there are 1 to a
/// million.
std::vector<std::uint64_t> seeds_from_json(const Json& json, const std::string& where);

}  // namespace ddtool

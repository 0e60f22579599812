#include "system/expect.hpp"

#include <algorithm>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {

void expect_between(const std::string& key, double value, double least, double most) {
    if (!(value >= least && value <= most)) {
        throw UsageError(key + ": expected " + Json(least).dump() + " to " + Json(most).dump() + ", not " +
                         Json(value).dump());
    }
}

std::size_t expect_one_of(const std::string& key, const std::string& word, std::span<const char* const> known) {
    const auto found = std::find(known.begin(), known.end(), word);
    if (found == known.end()) {
        throw UsageError(key + ": expected one of " + joined(std::vector<std::string>(known.begin(), known.end())) +
                         ", not '" + word + "'");
    }
    return static_cast<std::size_t>(found - known.begin());
}

}  // namespace ddtool

#include "system/seed_range.hpp"

#include <numeric>

#include "ddtool/base/error.hpp"

namespace ddtool {

std::vector<std::uint64_t> seeds_from_json(const Json& json, const std::string& where) {
    constexpr std::uint64_t most = 1'000'000;
    const auto count = json.at("count").get<std::uint64_t>();
    if (count == 0 || count > most) {
        throw UsageError(where + ".count: expected 1 to " + std::to_string(most));
    }
    std::vector<std::uint64_t> seeds(count);
    std::iota(seeds.begin(), seeds.end(), json.at("first").get<std::uint64_t>());
    return seeds;
}

}  // namespace ddtool

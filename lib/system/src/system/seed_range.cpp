#include "system/seed_range.hpp"

#include <numeric>

namespace ddtool {
namespace {

struct SeedRange {
    std::uint64_t first = 1;
    std::uint64_t count = 1;
};

const SettingTable<SeedRange>& seed_range_rows() {
    static const SettingTable<SeedRange> rows{
        {"first", &SeedRange::first, Allowed::seed(), "", "The first seed."},
        {"count", &SeedRange::count, Allowed::whole(1, 1e6), "", "Number of seeds, one after the other."},
    };
    return rows;
}

}  // namespace

const std::vector<Setting>& seed_range_setting_list() { return seed_range_rows().settings(); }

std::vector<std::uint64_t> seeds_from_json(const Json& json, const std::string& where) {
    const SeedRange range = seed_range_rows().checked(json, where);
    std::vector<std::uint64_t> seeds(range.count);
    std::iota(seeds.begin(), seeds.end(), range.first);
    return seeds;
}

}  // namespace ddtool

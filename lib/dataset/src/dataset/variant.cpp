#include "dataset/variant.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"

namespace ddtool::dataset {
namespace {

/// Draws even from an empty list, so that the other draws do not depend on it.
const Json* drawn_from(const Json& list, RandomStream& random) {
    const std::uint64_t index = random.index(list.empty() ? 1 : list.size());
    return list.empty() ? nullptr : &list[index];
}

void expect_each(const Json& list, const std::string& key, const std::string& expected, bool (*fits)(const Json&)) {
    const auto wrong = std::find_if_not(list.begin(), list.end(), fits);
    if (wrong != list.end()) {
        throw UsageError(key + ": expected " + expected + ", not " + wrong->dump());
    }
}

bool is_pair_of_numbers(const Json& value) {
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

}  // namespace

Variant draw_variant(const Json& item, RandomStream random, const std::string& where) {
    const Json& mix = item.at("mix");
    const auto key = [&](const char* name) { return std::string(where).append(".mix.").append(name); };
    expect_each(mix.at("particles"), key("particles"), "numbers of particles",
                [](const Json& value) { return value.is_number_integer() && value > 0; });
    expect_each(mix.at("lidars"), key("lidars"), "names of presets",
                [](const Json& value) { return value.is_string(); });
    expect_each(mix.at("odometry"), key("odometry"), "names of presets",
                [](const Json& value) { return value.is_string(); });
    expect_each(mix.at("update_distances"), key("update_distances"), "pairs [metres, radians]", is_pair_of_numbers);
    expect_each(mix.at("methods"), key("methods"), "names of methods",
                [](const Json& value) { return value.is_string(); });
    Variant variant;
    if (const Json* particles = drawn_from(mix.at("particles"), random)) {
        variant.filter["particles"] = *particles;
    }
    if (const Json* lidar = drawn_from(mix.at("lidars"), random)) {
        variant.lidar["preset"] = *lidar;
    }
    if (const Json* odometry = drawn_from(mix.at("odometry"), random)) {
        variant.odometry["preset"] = *odometry;
    }
    if (const Json* distances = drawn_from(mix.at("update_distances"), random)) {
        variant.filter["update_distance_m"] = (*distances)[0].get<double>();
        variant.filter["update_turn_rad"] = (*distances)[1].get<double>();
    }
    if (const Json* method = drawn_from(mix.at("methods"), random)) {
        variant.filter["method"] = *method;
    }
    return variant;
}

}  // namespace ddtool::dataset

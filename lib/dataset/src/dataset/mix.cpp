#include "dataset/mix.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"

namespace ddtool::dataset {
namespace {

/// Draws an entry of the list. A number is drawn even if the list is empty, so that the values drawn from the other
/// lists do not depend on it.
template <typename Value>
std::optional<Value> drawn(const std::vector<Value>& list, RandomStream& random) {
    const std::uint64_t index = random.index(list.empty() ? 1 : list.size());
    return list.empty() ? std::nullopt : std::optional(list[index]);
}

bool is_count(const Json& value) { return value.is_number_integer() && value > 0; }

bool is_text(const Json& value) { return value.is_string(); }

bool is_pair_of_numbers(const Json& value) {
    return value.is_array() && value.size() == 2 && value[0].is_number() && value[1].is_number();
}

/// Returns the lists of a mix by their keys, after a check that every item is of the expected kind.
class Lists {
public:
    Lists(const Json& mix, const std::string& where) : mix_(mix), where_(where) {}

    [[nodiscard]] const Json& of(const char* key, const std::string& expected, bool (*fits)(const Json&)) const {
        const Json& list = mix_.at(key);
        const auto wrong = std::find_if_not(list.begin(), list.end(), fits);
        if (wrong != list.end()) {
            throw UsageError(where_ + ".mix." + key + ": expected " + expected + ", not " + wrong->dump());
        }
        return list;
    }

private:
    const Json& mix_;
    const std::string& where_;
};

}  // namespace

Mix mix_from_json(const Json& json, const std::string& where) {
    const Lists lists(json, where);
    Mix mix{.particles = lists.of("particles", "numbers of particles", is_count),
            .lidars = lists.of("lidars", "names of presets", is_text),
            .odometry = lists.of("odometry", "names of presets", is_text),
            .update_distances = {},
            .methods = lists.of("methods", "names of methods", is_text)};
    for (const Json& pair : lists.of("update_distances", "pairs [metres, radians]", is_pair_of_numbers)) {
        mix.update_distances.push_back({pair[0].get<double>(), pair[1].get<double>()});
    }
    return mix;
}

Variant draw_variant(const Mix& mix, RandomStream random) {
    Variant variant;
    variant.particles = drawn(mix.particles, random);
    variant.lidar = drawn(mix.lidars, random);
    variant.odometry = drawn(mix.odometry, random);
    variant.update_distance = drawn(mix.update_distances, random);
    variant.method = drawn(mix.methods, random);
    return variant;
}

}  // namespace ddtool::dataset

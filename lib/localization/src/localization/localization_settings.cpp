#include "localization/localization_settings.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"
#include "methods/settings_json.hpp"

namespace ddtool::localization {
namespace {

constexpr const char* filter_name = "filter";
constexpr const char* own_name = "localization";

/// Settings of a filter that have no meaning in a known map: cells are those of the map, and no scan enters it; and
/// those of GMapping's filter, which has maps of its own.
const std::vector<std::string>& unused() {
    static const std::vector<std::string> keys{"insert_distance_m",  "insert_turn_rad", "grid",
                                               "gmapping",           "failed_match",    "resampling",
                                               "enhanced_resampling"};
    return keys;
}

const SettingTable<ModeResamplingSettings>& own_rows() {
    using Particles = ModeResamplingSettings;
    static const SettingTable<Particles> rows{
        {"most_particles", &Particles::most_particles, Allowed::whole(1, 10000), "",
         "The number of particles never exceeds this; the least is filter.particles."},
        {"kld_error", &Particles::kld_error, Allowed::number(0.001, 1.0), "",
         "So many particles are used that their distribution is, with a probability of .99, this near to the true one "
         "(Kullback-Leibler distance).",
         "Fox 2003, eq. 7"},
    };
    return rows;
}

}  // namespace

std::vector<Setting> localization_setting_list() {
    std::vector<Setting> filter = filter_setting_list();
    for (const std::string& key : unused()) {
        filter = without(std::move(filter), key);
    }
    return {{filter_name, {}, "", "", "", filter}, {own_name, {}, "", "", "", own_rows().settings()}};
}

Json default_localization_json() {
    Json filter = filter_settings_json({});
    for (const std::string& key : unused()) {
        filter.erase(key);
    }
    return {{filter_name, filter}, {own_name, own_rows().json({})}};
}

LocalizationSettings localization_from_json(const Json& json) {
    expect_allowed(json, localization_setting_list(), "");
    Json filter = filter_settings_json({});
    merge_settings(filter, json.at(filter_name), filter_name);
    LocalizationSettings settings{.filter = filter_settings_from_json(filter),
                                  .particles = own_rows().checked(json.at(own_name), own_name)};
    settings.particles.least_particles = settings.filter.rbpf.particles;
    if (settings.particles.most_particles < settings.particles.least_particles) {
        throw UsageError("localization.most_particles: expected at least filter.particles, which is " +
                         std::to_string(settings.particles.least_particles));
    }
    if (settings.filter.rbpf.likelihood_gain <= 0.0) {
        throw UsageError("filter.likelihood_gain: expected more than 0 for localisation, which weighs places by it");
    }
    return settings;
}

}  // namespace ddtool::localization

#include "dataset/run_id.hpp"

#include <utility>

#include "ddtool/filter/information_fusion.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/scan_matcher.hpp"
#include "ddtool/robot/scan_points.hpp"
#include "methods/settings_json.hpp"

namespace ddtool::dataset {
namespace {

/// A copy of the object with one more member, which is placed behind the member of the given key.
Json with_behind(const Json& object, const std::string& key, const std::string& added, const Json& value) {
    Json result = Json::object();
    for (const auto& [name, member] : object.items()) {
        result[name] = member;
        if (name == key) {
            result[added] = value;
        }
    }
    return result;
}

Json odometry_learning_json() {
    using Learning = OdometryLearning;
    return {{"scale_sd", Learning::scale_sd},
            {"bias_sd_rad_per_s", Learning::bias_sd_rad_per_s},
            {"noise",
             {{"translation_per_translation", Learning::noise.translation_per_translation},
              {"translation_per_rotation", Learning::noise.translation_per_rotation},
              {"rotation_per_translation", Learning::noise.rotation_per_translation},
              {"rotation_per_rotation", Learning::noise.rotation_per_rotation}}},
            {"noise_chords", Learning::noise_chords},
            {"remembered_chords", Learning::remembered_chords},
            {"chord_m", Learning::chord_m},
            {"chord_turn_rad", Learning::chord_turn_rad},
            {"observed_sd_m", Learning::observed_sd_m},
            {"observed_sd_rad", Learning::observed_sd_rad},
            {"caution", Learning::caution}};
}

Json identity_of_filter(Json filter) {
    filter = without_other_filters(std::move(filter));
    // as they were called then; what has these names now has the settings of GMapping here, too
    if (filter.at("method") == "rbpf") {
        filter["method"] = "gmapping";
    } else if (filter.at("method") == "paper-strategies-on-ours") {
        filter["method"] = "paper";
    }
    filter["grid"].erase("most_memory_mib");
    if (filter.at("gate").get<std::string>().empty()) {
        filter.erase("gate");
    }
    if (filter.at("full_weight_sd_m") == 0.0) {
        filter.erase("full_weight_sd_m");  // all weighed alike then
    }
    if (filter.at("points").at("deskew") == true) {
        filter["points"].erase("deskew");  // makes no difference to scans that were measured at once, as all were then
    }
    filter["points"]["normal_radius_m"] = ScanPoints::normal_radius_m;
    filter["points"]["line_flatness"] = ScanPoints::line_flatness;
    filter["fusion"] =
        with_behind(filter.at("fusion"), "least_degree", "normal_error_rad", InformationFusion::normal_error_rad);
    filter = with_behind(filter, "enhanced_resampling", "odometry_learning", odometry_learning_json());
    return with_behind(filter, "likelihood_gain", "min_match_score", ScanMatch::least_score);
}

}  // namespace

Json identity_of_simulation(Json simulation) {
    Json& odometry = simulation.at("odometry");
    if (odometry.contains("turn_error") && odometry.at("turn_error").is_null()) {
        odometry.erase("turn_error");
    }
    return simulation;
}

Json identity_of(Json configuration) {
    if (configuration.contains("simulation")) {
        configuration["simulation"] = identity_of_simulation(configuration.at("simulation"));
    }
    if (configuration.contains("filter")) {
        configuration["filter"] = identity_of_filter(configuration.at("filter"));
    }
    return configuration;
}

}  // namespace ddtool::dataset

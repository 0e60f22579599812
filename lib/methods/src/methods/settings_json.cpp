#include "methods/settings_json.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"

namespace ddtool {

DDTOOL_JSON_STRUCT(MotionNoise, translation_per_translation, translation_per_rotation, rotation_per_translation,
                   rotation_per_rotation)
DDTOOL_JSON_STRUCT(OccupancySettings, cell_size_m, hit_step, free_step, min_log_odds, max_log_odds)
DDTOOL_JSON_STRUCT(ScanPointsSettings, usable_range_m, spacing_m, normal_radius_m, line_flatness)
DDTOOL_JSON_STRUCT(ScanMatcherSettings, reach_m, max_iterations, beam_sigma_m, doubtful_score, search_turn_rad,
                   search_distance_m)
DDTOOL_JSON_STRUCT(RbpfSettings, particles, seed, update_distance_m, update_turn_rad, resample_share, likelihood_gain,
                   min_match_score, insert_distance_m, insert_turn_rad, motion, grid, points, matcher)

DDTOOL_JSON_STRUCT(MethodParts, detector, gate, search, trust, resampling, odometry)
DDTOOL_JSON_STRUCT(DetectionSettings, covariance_sd_m, doubt_share, every_m)
DDTOOL_JSON_STRUCT(CoarseFineSettings, step_m, turn_rad)
DDTOOL_JSON_STRUCT(CorrelativeSearchSettings, window_m, window_rad, steps, levels, degenerate_share)
DDTOOL_JSON_STRUCT(FusionSettings, least_degree, normal_error_rad, most_deviations, settled_m, settled_rad)
DDTOOL_JSON_STRUCT(EigenvalueGateSettings, least_share)
DDTOOL_JSON_STRUCT(EnhancedResamplingSettings, drop_below, perturbation_m, least_weight, most_weight)
DDTOOL_JSON_STRUCT(OdometryLearning, scale_sd, bias_sd_rad_per_s, noise, noise_chords, remembered_chords, chord_m,
                   chord_turn_rad, observed_sd_m, observed_sd_rad, caution)

namespace {

constexpr double smallest = std::numeric_limits<double>::min();

void expect_between(const Json& json, const std::string& path, double least, double most, const std::string& expected) {
    const Json::json_pointer pointer("/" + path);
    const double value = json.at(pointer);
    if (!(value >= least && value <= most)) {
        std::string key = "filter." + path;
        std::replace(key.begin(), key.end(), '/', '.');
        throw UsageError(key + ": expected " + expected + ", not " + json.at(pointer).dump());
    }
}

void expect_above_zero(const Json& json, const std::string& path) {
    expect_between(json, path, smallest, std::numeric_limits<double>::max(), "a number above 0");
}

}  // namespace

Json filter_settings_json(const FilterSettings& settings) {
    const MethodSettings& method = settings.method;
    Json json{{"method", method.method}};
    json.update(Json(method.parts));
    json.update(Json(settings.rbpf));
    json["detection"] = method.detection;
    json["coarse_fine"] = method.coarse_fine;
    json["correlative"] = method.correlative;
    json["fusion"] = method.fusion;
    json["eigenvalue_gate"] = method.eigenvalue_gate;
    json["enhanced_resampling"] = method.enhanced_resampling;
    json["odometry_learning"] = method.odometry_learning;
    return json;
}

Json parts_json(const MethodSettings& settings) { return parts_of(settings); }

Json common_filter_json() {
    Json json = filter_settings_json({});
    json.erase("seed");
    return json;
}

FilterSettings filter_settings_from_json(const Json& json) {
    expect_between(json, "particles", 1, 1e6, "1 to 1000000");
    expect_between(json, "seed", 0, 1.8e19, "a whole number, 0 or more");
    for (const char* path : {"update_distance_m", "update_turn_rad", "grid/cell_size_m", "points/usable_range_m",
                             "matcher/reach_m", "matcher/beam_sigma_m"}) {
        expect_above_zero(json, path);
    }
    for (const char* path : {"grid/hit_step", "grid/free_step"}) {
        expect_between(json, path, 1, 27, "1 to 27");
    }
    expect_between(json, "grid/min_log_odds", -100, -1, "-100 to -1");
    expect_between(json, "grid/max_log_odds", 1, 100, "1 to 100");
    FilterSettings settings{.rbpf = json.get<RbpfSettings>(),
                            .method = {.method = json.at("method"),
                                       .parts = json.get<MethodParts>(),
                                       .detection = json.at("detection"),
                                       .coarse_fine = json.at("coarse_fine"),
                                       .correlative = json.at("correlative"),
                                       .fusion = json.at("fusion"),
                                       .eigenvalue_gate = json.at("eigenvalue_gate"),
                                       .enhanced_resampling = json.at("enhanced_resampling"),
                                       .odometry_learning = json.at("odometry_learning")}};
    (void)parts_of(settings.method);  // an unknown method shows now
    return settings;
}

}  // namespace ddtool

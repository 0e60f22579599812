#include "dataset/build_settings.hpp"

#include "ddtool/base/error.hpp"
#include "ddtool/network/image_settings.hpp"
#include "ddtool/system/json_struct.hpp"
#include "methods/settings_json.hpp"
#include "sim/simulation_json.hpp"

namespace ddtool::dataset {

DDTOOL_JSON_STRUCT(ThinningSettings, every, most_per_run)
DDTOOL_JSON_STRUCT(LabelSettings, dispersion_weight, dispersion_threshold, fisher_ratio)
DDTOOL_JSON_STRUCT(BalanceSettings, degenerate, not_degenerate)
DDTOOL_JSON_STRUCT(AssemblySettings, seed, labels, balance, shard_megabytes)

Json default_build_json() {
    Json settings{
        {"worlds", Json::array()},
        {"logs", Json::array()},
        {"snapshots", Json::array()},
        {"mix",
         {{"particles", Json::array()},
          {"lidars", Json::array()},
          {"odometry", Json::array()},
          {"update_distances", Json::array()},
          {"methods", Json::array()}}},
        {"thinning", ThinningSettings{}},
        {"most_particle_updates", 60000U},
        {"simulation", sim::common_simulation_json()},
        {"filter", common_filter_json()},
    };
    settings.update(Json(AssemblySettings{}));
    settings["image"] = ImageSettings{};
    return settings;
}

AssemblySettings assembly_from_json(const Json& settings) {
    auto assembly = settings.get<AssemblySettings>();
    if (assembly.shard_megabytes == 0) {
        throw UsageError("shard_megabytes: expected 1 or more");
    }
    expect_valid(settings.at("image").get<ImageSettings>());
    (void)dispersion_label({}, assembly.labels);  // an unknown weight shows now
    return assembly;
}

ThinningSettings thinning_from_json(const Json& thinning) {
    const auto settings = thinning.get<ThinningSettings>();
    if (settings.every == 0 || settings.most_per_run == 0) {
        throw UsageError("thinning: expected every and most_per_run to be 1 or more");
    }
    return settings;
}

}  // namespace ddtool::dataset

#include "dataset/build_settings.hpp"

#include "methods/settings_json.hpp"
#include "network/image_setting_rows.hpp"
#include "sim/simulation_json.hpp"

namespace ddtool::dataset {
namespace {

const Allowed most_particle_updates = Allowed::whole(1, 1e12);

const SettingTable<ThinningSettings>& thinning_rows() {
    using Thinning = ThinningSettings;
    static const SettingTable<Thinning> rows{
        {"every", &Thinning::every, Allowed::whole(1, 1e9), "",
         "One of so many snapshots in a row is kept, chosen by chance: neighbours are near-copies."},
        {"most_per_run", &Thinning::most_per_run, Allowed::whole(1, 1e9), "",
         "No more snapshots of a run are kept, chosen by chance."},
    };
    return rows;
}

const SettingTable<LabelSettings>& label_rows() {
    using Labels = LabelSettings;
    static const SettingTable<Labels> rows{
        {"dispersion_weight", &Labels::dispersion_weight,
         Allowed::one_of({dispersion_weight_names.begin(), dispersion_weight_names.end()}), "",
         "The weight of which the dispersion is taken.", "docs/labels.md"},
        {"dispersion_threshold", &Labels::dispersion_threshold, Allowed::number(0.0, 1e6), "",
         "A snapshot is degenerate above this dispersion.", "the paper, eq. label_explain"},
        {"fisher_ratio", &Labels::fisher_ratio, Allowed::number(0.0, 1e6), "",
         "A snapshot is degenerate where the scan's standard deviation exceeds the odometry's by this factor."},
    };
    return rows;
}

const SettingTable<BalanceSettings>& balance_rows() {
    using Balance = BalanceSettings;
    static const SettingTable<Balance> rows{
        {"degenerate", &Balance::degenerate, Allowed::whole(0, 1e12), "", "Number of degenerate samples wanted.",
         "the paper's data set"},
        {"not_degenerate", &Balance::not_degenerate, Allowed::whole(0, 1e12), "", "Number of other samples wanted.",
         "the paper's data set"},
    };
    return rows;
}

const SettingTable<AssemblySettings>& assembly_rows() {
    using Assembly = AssemblySettings;
    static const SettingTable<Assembly> rows{
        {"seed", &Assembly::seed, Allowed::seed(), "", "The choice of samples follows from it."},
        {"labels", &Assembly::labels, label_rows()},
        {"balance", &Assembly::balance, balance_rows()},
        {"shard_megabytes", &Assembly::shard_megabytes, Allowed::whole(1, 1e6), "MB",
         "A shard is closed when its particles reach this size."},
    };
    return rows;
}

Setting list_of(const std::string& key, const std::string& meaning) {
    return {key, Allowed::other(), "", meaning, "docs/dataset.md", {}};
}

}  // namespace

std::vector<Setting> build_setting_list() {
    std::vector<Setting> settings{
        list_of("worlds", "Simulated drives to take snapshots of: names of worlds, or objects."),
        list_of("logs", "Recorded drives to take snapshots of: files, or objects."),
        list_of("snapshots", "Files of snapshots to take as they are."),
        {"mix",
         {},
         "",
         "",
         "",
         {list_of("particles", "Numbers of particles that runs draw from."),
          list_of("lidars", "Presets of the lidar that simulated runs draw from."),
          list_of("odometry", "Presets of the odometry that simulated runs draw from."),
          list_of("update_distances", "Pairs of update_distance_m and update_turn_rad that runs draw from."),
          list_of("methods", "Methods that runs draw from.")}},
        {"thinning", {}, "", "", "", thinning_rows().settings()},
        {"most_particle_updates",
         most_particle_updates,
         "",
         "A simulated drive that takes more updates, times particles, is cut to a window of so many.",
         "",
         {}},
        {"simulation", {}, "", "", "", sim::common_simulation_setting_list()},
        {"filter", {}, "", "", "", without(filter_setting_list(), "seed")},
    };
    const std::vector<Setting>& assembly = assembly_rows().settings();
    settings.insert(settings.end(), assembly.begin(), assembly.end());
    settings.push_back({"image", {}, "", "", "", image_setting_rows().settings()});
    return settings;
}

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
        {"thinning", thinning_rows().json({})},
        {"most_particle_updates", 60000U},
        {"simulation", sim::common_simulation_json()},
        {"filter", common_filter_json()},
    };
    // A method that acts on its detector's degree would make swarms that depend on the detector that learns from them.
    settings["filter"]["method"] = "rbpf";
    settings.update(assembly_rows().json({}));
    settings["image"] = ImageSettings{};
    return settings;
}

AssemblySettings assembly_from_json(const Json& settings) {
    expect_allowed(settings.at("image"), image_setting_rows().settings(), "image");
    expect_valid(settings.at("image").get<ImageSettings>(), "image");
    return assembly_rows().checked(settings);
}

ThinningSettings thinning_from_json(const Json& thinning) { return thinning_rows().checked(thinning, "thinning"); }

void expect_valid_plan(const Json& settings) {
    (void)thinning_from_json(settings.at("thinning"));
    expect_allowed(settings.at("most_particle_updates"), most_particle_updates, "", "most_particle_updates");
}

}  // namespace ddtool::dataset

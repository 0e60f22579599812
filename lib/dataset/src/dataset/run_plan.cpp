#include "dataset/run_plan.hpp"

#include <filesystem>
#include <set>

#include "base/pattern.hpp"
#include "dataset/build_settings.hpp"
#include "dataset/run_id.hpp"
#include "dataset/variant.hpp"
#include "ddtool/base/error.hpp"
#include "methods/settings_json.hpp"
#include "sim/simulation_json.hpp"
#include "sim/world_catalogue.hpp"
#include "sim/world_fingerprint.hpp"
#include "system/fingerprint.hpp"
#include "system/seed_range.hpp"

namespace ddtool::dataset {
namespace {

/// Raised when parts of before no longer hold what this program would compute.
constexpr int format = 2;

/// A plain world and its textured variant are one scene: the robot drives the same way between the same walls.
std::string plain_name(std::string world) {
    constexpr std::string_view textured = "-textured";
    if (world.ends_with(textured)) {
        world.resize(world.size() - textured.size());
    }
    return world.ends_with(".json") ? std::filesystem::path(world).stem().string() : world;
}

class Planner {
public:
    explicit Planner(const Json& settings) : settings_(settings) {}

    RunPlan plan() {
        for_each_item("worlds", "world", {"seeds", "mix", "simulation", "filter"}, &Planner::add_world);
        for_each_item("logs", "log", {"seeds", "mix", "filter", "range_sd_m"}, &Planner::add_log);
        for_each_item("snapshots", "snapshots", {}, &Planner::add_snapshots);
        if (plan_.runs.empty()) {
            throw UsageError("worlds, logs, snapshots: expected one or more sources");
        }
        return std::move(plan_);
    }

private:
    using Add = void (Planner::*)(const Json& item, const std::string& where);

    /// Items are names or objects; what an object does not say is as the whole configuration has it.
    void for_each_item(const std::string& list, const std::string& kind, const std::vector<std::string>& keys,
                       Add add) {
        std::size_t index = 0;
        for (const Json& item : settings_.at(list)) {
            const std::string where = std::string(list).append("[").append(std::to_string(index++)).append("]");
            Json settings = item_defaults(kind, keys);
            merge_settings(settings, item.is_string() ? Json{{kind, item}} : item, where);
            expect_named(settings, kind, where);
            (this->*add)(settings, where);
        }
    }

    /// Of the keys that the whole configuration has too, its values.
    [[nodiscard]] Json item_defaults(const std::string& kind, const std::vector<std::string>& keys) const {
        Json defaults{{kind, ""}, {"scene", ""}};
        for (const std::string& key : keys) {
            defaults[key] = settings_.value(key, Json());
        }
        if (defaults.contains("seeds")) {
            defaults["seeds"] = {{"first", 1U}, {"count", 1U}};
        }
        if (defaults.contains("range_sd_m")) {
            defaults["range_sd_m"] = 0.02;
        }
        return defaults;
    }

    static void expect_named(const Json& item, const std::string& kind, const std::string& where) {
        if (item.at(kind).get<std::string>().empty()) {
            throw UsageError(where + ": expected the name of a " + kind);
        }
    }

    void add_world(const Json& item, const std::string& where) {
        const auto pattern = item.at("world").get<std::string>();
        std::string last;
        for (const std::uint64_t seed : seeds_from_json(item.at("seeds"), where + ".seeds")) {
            const std::string world = expand(pattern, "", seed);
            if (world != last) {
                add_source("world", world);
                last = world;
            }
            const Variant variant = draw_variant(item, chance(world, seed), where);
            const Json simulation = simulation_of(item, variant, seed);
            const Json filter = filter_of(item, variant, seed);
            PlannedRun run{entry_of(item, filter, plain_name(world)), world, {}};
            run.entry.lidar = simulation.at("lidar").at("preset").get<std::string>();
            run.entry.odometry = simulation.at("odometry").at("preset").get<std::string>();
            run.configuration = {{"world", sim::world_fingerprint(sim::load_world(world))},
                                 {"simulation", simulation},
                                 {"most_particle_updates", settings_.at("most_particle_updates")},
                                 {"filter", filter}};
            add_run(std::move(run));
        }
    }

    void add_log(const Json& item, const std::string& where) {
        const auto path = item.at("log").get<std::string>();
        expect_allowed(item.at("range_sd_m"), Allowed::number(1e-6, 100.0), "m", where + ".range_sd_m");
        const std::string name = std::filesystem::path(path).stem().string();
        const std::string content = file_fingerprint(path);
        add_source("log", name);
        for (const std::uint64_t seed : seeds_from_json(item.at("seeds"), where + ".seeds")) {
            const Variant variant = draw_variant(item, chance(name, seed), where);
            const Json filter = filter_of(item, variant, seed);
            PlannedRun run{entry_of(item, filter, name), path, {}};
            run.configuration = {{"log", content}, {"range_sd_m", item.at("range_sd_m")}, {"filter", filter}};
            add_run(std::move(run));
        }
    }

    void add_snapshots(const Json& item, const std::string& /*where*/) {
        const auto path = item.at("snapshots").get<std::string>();
        const std::string name = std::filesystem::path(path).stem().string();
        add_source("snapshots", name);
        PlannedRun run{{}, path, {}};
        run.entry.scene = scene_of(item, name);
        run.configuration = {{"snapshots", file_fingerprint(path)}};
        add_run(std::move(run));
    }

    void add_source(const std::string& kind, const std::string& name) { plan_.sources.push_back({kind, name}); }

    [[nodiscard]] RandomStream chance(const std::string& name, std::uint64_t seed) const {
        return {settings_.at("seed").get<std::uint64_t>(), Fingerprint().add(name).value(), seed};
    }

    static std::string scene_of(const Json& item, const std::string& otherwise) {
        const auto scene = item.at("scene").get<std::string>();
        return scene.empty() ? otherwise : scene;
    }

    static RunEntry entry_of(const Json& item, const Json& filter, const std::string& scene) {
        RunEntry entry;
        entry.scene = scene_of(item, scene);
        entry.seed = filter.at("seed").get<std::uint64_t>();
        entry.particles = filter.at("particles").get<std::uint64_t>();
        entry.method = filter.at("method").get<std::string>();
        entry.update_distance_m = filter.at("update_distance_m").get<double>();
        entry.update_turn_rad = filter.at("update_turn_rad").get<double>();
        return entry;
    }

    static Json filter_of(const Json& item, const Variant& variant, std::uint64_t seed) {
        Json filter = item.at("filter");
        filter.update(variant.filter);
        filter["seed"] = seed;
        (void)filter_settings_from_json(filter);  // a value that makes no sense shows now, not in every run
        return filter;
    }

    static Json simulation_of(const Json& item, const Variant& variant, std::uint64_t seed) {
        Json simulation = item.at("simulation");
        simulation["lidar"].update(variant.lidar);
        simulation["odometry"].update(variant.odometry);
        simulation["seed"] = seed;
        (void)sim::simulation_from_json(simulation, "simulation");
        return simulation;
    }

    void add_run(PlannedRun run) {
        run.configuration["format"] = format;
        run.configuration["seed"] = settings_.at("seed");
        run.configuration["thinning"] = settings_.at("thinning");
        run.entry.source = static_cast<std::uint32_t>(plan_.sources.size() - 1);
        run.entry.id = run_id(run.configuration);
        if (ids_.insert(run.entry.id).second) {
            plan_.runs.push_back(std::move(run));
        }
    }

    const Json& settings_;
    RunPlan plan_;
    std::set<std::string> ids_;
};

}  // namespace

RunPlan plan_runs(const Json& settings) {
    expect_valid_plan(settings);
    return Planner(settings).plan();
}

std::string title_of(const RunPlan& plan, const PlannedRun& run) {
    std::string title = plan.sources[run.entry.source].name;
    if (run.entry.particles > 0) {
        title +=
            " / seed " + std::to_string(run.entry.seed) + " / " + std::to_string(run.entry.particles) + " particles";
    }
    return title;
}

}  // namespace ddtool::dataset

#include "dataset/run_plan.hpp"

#include <filesystem>
#include <set>

#include "base/pattern.hpp"
#include "dataset/build_settings.hpp"
#include "dataset/mix.hpp"
#include "dataset/run_id.hpp"
#include "ddtool/base/error.hpp"
#include "methods/settings_json.hpp"
#include "sim/simulation_json.hpp"
#include "sim/world_catalogue.hpp"
#include "sim/world_fingerprint.hpp"
#include "system/fingerprint.hpp"
#include "system/seed_range.hpp"

namespace ddtool::dataset {
namespace {

/// Part of every run's key. It is increased when parts that were made earlier differ from what this program would
/// compute.
constexpr int plan_format = 2;

/// The scene's name of a world. A plain world and its textured variant are one scene, because the robot drives the same
/// path between the same walls.
std::string plain_name(std::string world) {
    constexpr std::string_view textured = "-textured";
    if (world.ends_with(textured)) {
        world.resize(world.size() - textured.size());
    }
    return world.ends_with(".json") ? std::filesystem::path(world).stem().string() : world;
}

class Planner {
public:
    explicit Planner(const Json& settings)
        : settings_(settings), thinning_(thinning_from_json(settings.at("thinning"))) {}

    RunPlan plan() {
        const Json one_seed{{"first", 1U}, {"count", 1U}};
        const Json& mix = settings_.at("mix");
        const Json& filter = settings_.at("filter");
        add_all("worlds", "world",
                {{"seeds", one_seed}, {"mix", mix}, {"simulation", settings_.at("simulation")}, {"filter", filter}},
                &Planner::add_world);
        add_all("logs", "log", {{"seeds", one_seed}, {"mix", mix}, {"filter", filter}, {"range_sd_m", 0.02}},
                &Planner::add_log);
        add_all("snapshots", "snapshots", Json::object(), &Planner::add_snapshots);
        if (plan_.runs.empty()) {
            throw UsageError("worlds, logs, snapshots: expected one or more sources");
        }
        return std::move(plan_);
    }

private:
    using Add = void (Planner::*)(const Json& item, const std::string& where);

    /// Calls `add` for every item of the list. An item is a name or an object; keys that an object does not have are
    /// filled in from the defaults.
    void add_all(const std::string& list, const std::string& kind, const Json& defaults, Add add) {
        std::size_t index = 0;
        for (const Json& item : settings_.at(list)) {
            const std::string where = std::string(list).append("[").append(std::to_string(index++)).append("]");
            Json settings{{kind, ""}, {"scene", ""}};
            settings.update(defaults);
            merge_settings(settings, item.is_string() ? Json{{kind, item}} : item, where);
            if (settings.at(kind).get<std::string>().empty()) {
                throw UsageError(std::string(where).append(": expected the name of a ").append(kind));
            }
            (this->*add)(settings, where);
        }
    }

    void add_world(const Json& item, const std::string& where) {
        const auto pattern = item.at("world").get<std::string>();
        const Mix mix = mix_from_json(item.at("mix"), where);
        const auto most_particle_updates = settings_.at("most_particle_updates").get<std::uint64_t>();
        std::string last;
        for (const std::uint64_t seed : seeds_from_json(item.at("seeds"), where + ".seeds")) {
            const std::string world = expand(pattern, "", seed);
            if (world != last) {
                add_source(SourceKind::world, world);
                last = world;
            }
            const Variant variant = draw_variant(mix, chance(world, seed));
            const Json simulation = simulation_of(item, variant, seed);
            const Json filter = filter_of(item, variant, seed);
            const FilterSettings filter_settings = filter_settings_from_json(filter);
            RunEntry entry = entry_of(item, filter_settings, plain_name(world));
            entry.lidar = simulation.at("lidar").at("preset").get<std::string>();
            entry.odometry = simulation.at("odometry").at("preset").get<std::string>();
            add_run(
                std::move(entry),
                WorldRun{.world = world,
                         .simulation = sim::simulation_from_json(simulation),
                         .most_particle_updates = most_particle_updates,
                         .filter = filter_settings,
                         .drive_key = Fingerprint().add(world).add(identity_of_simulation(simulation).dump()).value()},
                {{"world", sim::world_fingerprint(sim::load_world(world))},
                 {"simulation", simulation},
                 {"most_particle_updates", most_particle_updates},
                 {"filter", filter}});
        }
    }

    void add_log(const Json& item, const std::string& where) {
        const auto path = item.at("log").get<std::string>();
        const Mix mix = mix_from_json(item.at("mix"), where);
        expect_allowed(item.at("range_sd_m"), Allowed::number(1e-6, 100.0), "m", where + ".range_sd_m");
        const std::string name = std::filesystem::path(path).stem().string();
        const std::string content = file_fingerprint(path);
        add_source(SourceKind::log, name);
        for (const std::uint64_t seed : seeds_from_json(item.at("seeds"), where + ".seeds")) {
            const Variant variant = draw_variant(mix, chance(name, seed));
            const Json filter = filter_of(item, variant, seed);
            const FilterSettings filter_settings = filter_settings_from_json(filter);
            add_run(entry_of(item, filter_settings, name),
                    LogRun{path, item.at("range_sd_m").get<double>(), filter_settings},
                    {{"log", content}, {"range_sd_m", item.at("range_sd_m")}, {"filter", filter}});
        }
    }

    void add_snapshots(const Json& item, const std::string& /*where*/) {
        const auto path = item.at("snapshots").get<std::string>();
        const std::string name = std::filesystem::path(path).stem().string();
        add_source(SourceKind::snapshots, name);
        RunEntry entry;
        entry.scene = scene_of(item, name);
        add_run(std::move(entry), RecordedRun{path}, {{"snapshots", file_fingerprint(path)}});
    }

    void add_source(SourceKind kind, const std::string& name) { plan_.sources.push_back({kind, name}); }

    [[nodiscard]] RandomStream chance(const std::string& name, std::uint64_t seed) const {
        return {settings_.at("seed").get<std::uint64_t>(), Fingerprint().add(name).value(), seed};
    }

    static std::string scene_of(const Json& item, const std::string& otherwise) {
        const auto scene = item.at("scene").get<std::string>();
        return scene.empty() ? otherwise : scene;
    }

    static RunEntry entry_of(const Json& item, const FilterSettings& filter, const std::string& scene) {
        RunEntry entry;
        entry.scene = scene_of(item, scene);
        entry.seed = filter.rbpf.seed;
        entry.particles = filter.rbpf.particles;
        entry.method = filter.method.method;
        const UpdateMotion motion = update_motion(filter);
        entry.update_distance_m = motion.distance_m;
        entry.update_turn_rad = motion.turn_rad;
        return entry;
    }

    static Json filter_of(const Json& item, const Variant& variant, std::uint64_t seed) {
        Json filter = item.at("filter");
        if (variant.particles) {
            filter["particles"] = *variant.particles;
        }
        if (variant.update_distance) {
            // for either filter, whichever the method uses
            for (Json* const group : {&filter, &filter["gmapping"]}) {
                (*group)["update_distance_m"] = variant.update_distance->distance_m;
                (*group)["update_turn_rad"] = variant.update_distance->turn_rad;
            }
        }
        if (variant.method) {
            filter["method"] = *variant.method;
        }
        filter["seed"] = seed;
        (void)filter_settings_from_json(filter);  // checks all values, before callers take single ones from the JSON
        return filter;
    }

    static Json simulation_of(const Json& item, const Variant& variant, std::uint64_t seed) {
        Json simulation = item.at("simulation");
        if (variant.lidar) {
            simulation["lidar"]["preset"] = *variant.lidar;
        }
        if (variant.odometry) {
            simulation["odometry"]["preset"] = *variant.odometry;
        }
        simulation["seed"] = seed;
        (void)sim::simulation_from_json(simulation, "simulation");
        return simulation;
    }

    template <typename Source>
    void add_run(RunEntry entry, Source source, Json configuration) {
        configuration["format"] = plan_format;
        configuration["seed"] = settings_.at("seed");
        configuration["thinning"] = settings_.at("thinning");
        jobs::Key key(identity_of(std::move(configuration)));
        entry.source = static_cast<std::uint32_t>(plan_.sources.size() - 1);
        entry.id = key.id();
        if (ids_.insert(entry.id).second) {
            plan_.runs.push_back({std::move(entry), std::move(source), thinning_, std::move(key)});
        }
    }

    const Json& settings_;
    ThinningSettings thinning_;
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

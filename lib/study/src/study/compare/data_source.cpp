#include "study/compare/data_source.hpp"

#include <filesystem>

#include "base/pattern.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/methods/driven_scans.hpp"
#include "sim/simulated_stream.hpp"
#include "sim/simulation_json.hpp"
#include "sim/world_catalogue.hpp"
#include "sim/world_fingerprint.hpp"
#include "system/fingerprint.hpp"

namespace ddtool::compare {
namespace {

Json world_defaults(const Json& item, const Json& simulation) {
    if (item.contains("log")) {
        return {{"name", ""}, {"log", ""}, {"reference", ""}, {"relations", ""}};
    }
    return {{"name", ""}, {"world", ""}, {"simulation", simulation}};
}

std::string default_name(const Json& settings) {
    return settings.contains("log") ? std::filesystem::path(settings.at("log").get<std::string>()).stem().string()
                                    : settings.at("world").get<std::string>();
}

}  // namespace

WorldEntry::WorldEntry(const Json& item, const Json& simulation, const std::string& where) {
    const Json changes = item.is_string() ? Json{{"world", item}} : item;
    settings_ = world_defaults(changes, simulation);
    merge_settings(settings_, changes, where);
    name_ = settings_.at("name").get<std::string>();
    if (name_.empty()) {
        name_ = default_name(settings_);
    }
}

DataSource WorldEntry::data(std::uint64_t seed) const { return settings_.contains("log") ? logged() : simulated(seed); }

DataSource WorldEntry::simulated(std::uint64_t seed) const {
    const std::string world = expand(settings_.at("world").get<std::string>(), name_, seed);
    Json simulation = settings_.at("simulation");
    simulation["seed"] = seed;
    DataSource source;
    source.identity = {
        {"world", world}, {"fingerprint", sim::world_fingerprint(sim::load_world(world))}, {"simulation", simulation}};
    source.open = [world, settings = sim::simulation_from_json(simulation, "simulation")](const LogProblemHandler&) {
        return std::make_unique<sim::SimulatedStream>(sim::load_world(world), settings);
    };
    return source;
}

DataSource WorldEntry::logged() const {
    const auto text = [&](const char* key) { return settings_.at(key).get<std::string>(); };
    DataSource source{.open = {},
                      .reference_file = text("reference"),
                      .relations_file = text("relations"),
                      .identity = {{"log", text("log")}, {"fingerprint", file_fingerprint(text("log"))}}};
    for (const char* key : {"reference", "relations"}) {
        source.identity[key] = text(key).empty() ? "" : file_fingerprint(text(key));
    }
    source.open = [path = text("log")](const LogProblemHandler& on_problem) {
        return std::make_unique<DrivenScans>(open_log(path, LogOptions{}, on_problem), RbpfSettings{});
    };
    return source;
}

}  // namespace ddtool::compare

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

WorldEntry::WorldEntry(const Json& item, const Json& simulation, const std::string& where) {
    const auto merged = [&](Json settings) {
        merge_settings(settings, item.is_string() ? Json{{"world", item}} : item, where);
        name_ = settings.at("name").get<std::string>();
        return settings;
    };
    std::string otherwise;
    if (item.is_object() && item.contains("log")) {
        const Json settings = merged({{"name", ""}, {"log", ""}, {"reference", ""}, {"relations", ""}});
        const Logged log{settings.at("log"), settings.at("reference"), settings.at("relations")};
        otherwise = std::filesystem::path(log.log).stem().string();
        source_ = log;
    } else {
        const Json settings = merged({{"name", ""}, {"world", ""}, {"simulation", simulation}});
        const Simulated world{settings.at("world"), settings.at("simulation")};
        otherwise = world.pattern;
        source_ = world;
    }
    if (name_.empty()) {
        name_ = otherwise;
    }
}

DataSource WorldEntry::data(std::uint64_t seed) const {
    return std::visit([&](const auto& source) { return data_of(source, seed); }, source_);
}

DataSource WorldEntry::data_of(const Simulated& source, std::uint64_t seed) const {
    const std::string world = expand(source.pattern, name_, seed);
    Json simulation = source.simulation;
    simulation["seed"] = seed;
    DataSource data;
    data.identity = {
        {"world", world}, {"fingerprint", sim::world_fingerprint(sim::load_world(world))}, {"simulation", simulation}};
    data.open = [world, settings = sim::simulation_from_json(simulation, "simulation")](const LogProblemHandler&) {
        return std::make_unique<sim::SimulatedStream>(sim::load_world(world), settings);
    };
    return data;
}

DataSource WorldEntry::data_of(const Logged& source, std::uint64_t /*seed*/) const {
    const auto fingerprint = [](const std::string& file) { return file.empty() ? "" : file_fingerprint(file); };
    DataSource data{.open = {},
                    .reference_file = source.reference,
                    .relations_file = source.relations,
                    .identity = {{"log", source.log},
                                 {"fingerprint", file_fingerprint(source.log)},
                                 {"reference", fingerprint(source.reference)},
                                 {"relations", fingerprint(source.relations)}}};
    data.open = [path = source.log](const LogProblemHandler& on_problem) {
        return std::make_unique<DrivenScans>(open_log(path, LogOptions{}, on_problem), RbpfSettings{});
    };
    return data;
}

}  // namespace ddtool::compare

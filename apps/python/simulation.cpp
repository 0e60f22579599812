#include "sim/simulation.hpp"

#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <string>

#include "ddtool/base/error.hpp"
#include "host.hpp"
#include "scan.hpp"
#include "sim/simulation_json.hpp"
#include "sim/simulation_log.hpp"
#include "sim/world_catalogue.hpp"
#include "sources.hpp"
#include "trajectory.hpp"

namespace ddtool::python {
namespace {

struct HeldSimulation {
    std::string world;
    sim::Simulation simulation;
};

std::shared_ptr<HeldSimulation> simulate(const py::object& world, const std::optional<std::uint64_t>& seed,
                                         const std::optional<py::dict>& settings) {
    Json all = sim::default_simulation_json();
    merge_dict(all, settings);
    Json given{{"world", py::module_::import("os").attr("fspath")(world).cast<std::string>()}};
    if (given["world"].get<std::string>().ends_with(".json")) {
        static_cast<void>(existing_path(world));
    }
    if (seed) {
        given["seed"] = *seed;
    }
    merge_settings(all, given, "arguments");
    const std::string name = all.at("world");
    const sim::SimulationSettings wanted = sim::simulation_from_json(all);
    return without_gil([&] {
        const sim::World drawn = sim::load_world(name);
        return std::make_shared<HeldSimulation>(HeldSimulation{drawn.name, sim::Simulation(drawn, wanted)});
    });
}

std::shared_ptr<HeldScan> scan_at(const HeldSimulation& held, py::ssize_t index) {
    const auto count = static_cast<py::ssize_t>(held.simulation.frame_count());
    const py::ssize_t at = index < 0 ? index + count : index;
    if (at < 0 || at >= count) {
        throw py::index_error("the simulation has " + std::to_string(count) + " scans");
    }
    return without_gil([&] {
        sim::SimulatedFrame made = held.simulation.frame(static_cast<std::size_t>(at));
        return std::make_shared<HeldScan>(HeldScan{std::move(made.frame), made.fisher_information});
    });
}

void write_log(const HeldSimulation& held, const py::object& path) {
    const auto file = py::module_::import("os").attr("fspath")(path).cast<std::string>();
    without_gil([&] {
        sim::write_simulation_log(held.simulation, file, [](std::size_t scans) {
            if (scans % 16 == 0) {
                stop_if_asked();
            }
        });
    });
}

std::shared_ptr<HeldTrajectory> held(Trajectory poses) {
    return std::make_shared<HeldTrajectory>(HeldTrajectory{std::move(poses)});
}

}  // namespace

void add_simulations(py::module_& module) {
    py::class_<HeldSimulation, std::shared_ptr<HeldSimulation>>(module, "Simulation",
                                                                R"(A drive through a world; simulate() makes it.

A sequence of Scan with true poses and Fisher information: it has a length, an index, and can be iterated. Each scan is
computed when it is asked for, and always has the same bytes.)")
        .def("__len__", [](const HeldSimulation& simulation) { return simulation.simulation.frame_count(); })
        .def("__getitem__", &scan_at, py::arg("index"))
        .def("__iter__",
             [](const py::object& self) { return py::reinterpret_steal<py::object>(PySeqIter_New(self.ptr())); })
        .def_property_readonly(
            "world", [](const HeldSimulation& simulation) { return simulation.world; }, "The name of the world.")
        .def(
            "truth", [](const HeldSimulation& simulation) { return held(simulation.simulation.truth_at_scans()); },
            "The true poses, world_from_robot, at the stamps of the scans.")
        .def(
            "odometry", [](const HeldSimulation& simulation) { return held(simulation.simulation.odometry()); },
            "odom_from_robot at the rate of the odometry.")
        .def("write", &write_log, py::arg("path"), "Writes the log that a robot would have recorded, an MCAP file.")
        .def("__repr__", [](const HeldSimulation& simulation) {
            return "<ddtool.Simulation of '" + simulation.world + "', " +
                   std::to_string(simulation.simulation.frame_count()) + " scans>";
        });
    module.def("simulate", &simulate, py::arg("world"), py::kw_only(), py::arg("seed") = py::none(),
               py::arg("settings") = py::none(),
               R"(Drives a robot through a world where the truth is known.

world: one of worlds(), one drawn by a seed ("random:office:17"), or a JSON file; with -textured behind it, the walls
    have doors, skirting and pillars.
seed: of the sensors' noise; 1 if not given.
settings: those of `ddtool simulate` by their names in JSON: {"lidar.preset": "rplidar-a1"}.)");
    module.def(
        "worlds",
        [] {
            py::dict worlds;
            for (const sim::WorldEntry& entry : sim::list_worlds()) {
                worlds[py::str(entry.name)] = entry.description;
            }
            return worlds;
        },
        "The names of the worlds, each with a description.");
}

}  // namespace ddtool::python

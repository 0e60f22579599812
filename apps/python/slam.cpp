#include "run.hpp"

#include <pybind11/stl.h>

#include "arrays.hpp"
#include "grid_map.hpp"
#include "host.hpp"
#include "localization/localization_settings.hpp"
#include "logs/stream/log_settings.hpp"
#include "maps/any_map.hpp"
#include "maps/going_on.hpp"
#include "methods/settings_json.hpp"
#include "swarm.hpp"
#include "trajectory.hpp"

namespace ddtool::python {
namespace {

/// Settings that arguments of their own stand for. One that is not given leaves the setting as it is.
struct CommonArguments {
    std::optional<std::string> method;
    std::optional<std::uint64_t> particles;
    std::optional<std::uint64_t> seed;
    GivenDetector detector;
    std::optional<py::dict> settings;
};

/// The defaults with what was given, as the options of a command come after its files and --set.
Json merged(Json settings, const CommonArguments& given) {
    merge_dict(settings, given.settings);
    Json changes = Json::object();
    const auto change = [&changes](const char* key, const auto& value) {
        if (value) {
            changes["filter"][key] = *value;
        }
    };
    change("method", given.method);
    change("particles", given.particles);
    change("seed", given.seed);
    if (!given.detector.name.empty()) {
        changes["filter"]["detector"] = given.detector.name;
    }
    merge_settings(settings, changes, "arguments");
    return settings;
}

class Slam : public Run {
    using Run::Run;
};
class MapLocalizer : public Run {
    using Run::Run;
};

std::unique_ptr<Slam> make_slam(const std::optional<std::string>& method, const std::optional<std::uint64_t>& particles,
                                const std::optional<std::uint64_t>& seed, const py::object& detector,
                                const std::optional<py::dict>& settings, std::size_t threads) {
    const CommonArguments given{method, particles, seed, detector_from(detector), settings};
    Json all = merged({{"log", default_log_settings()},
                       {"filter", filter_settings_json({})},
                       {"back_end", "none"},
                       {maps::going_on_name, maps::going_on_json({})}},
                      given);
    if (all.at("back_end") != "none") {
        throw UsageError("back_end: expected none; the pose graph runs in `ddtool slam` alone");
    }
    const FilterSettings filter = filter_settings_from_json(all.at("filter"));
    return std::make_unique<Slam>(filter, std::move(all), given.detector, threads,
                                  [](const FilterSettings& wanted, const DetectorTable& detectors, ThreadPool& pool) {
                                      return make_filter(wanted, detectors, pool);
                                  });
}

std::unique_ptr<MapLocalizer> make_localizer(const py::object& map, const py::object& initial_pose,
                                             const std::optional<std::string>& method,
                                             const std::optional<std::uint64_t>& particles,
                                             const std::optional<std::uint64_t>& seed, const py::object& detector,
                                             const std::optional<py::dict>& settings, std::size_t threads) {
    const std::filesystem::path file = existing_path(map);
    const std::optional<localization::StartPose> start =
        initial_pose.is_none()
            ? std::nullopt
            : std::optional(localization::StartPose{.pose = pose_from(initial_pose, "initial_pose")});
    const CommonArguments given{method, particles, seed, detector_from(detector), settings};
    Json defaults{{"log", default_log_settings()}};
    defaults.update(localization::default_localization_json());
    Json all = merged(std::move(defaults), given);
    localization::LocalizationSettings wanted = localization::localization_from_json(all);
    const auto grid = without_gil(
        [&] { return std::make_shared<const OccupancyGrid>(maps::read_any_map(file, maps::MapParts::grid).grid); });
    wanted.filter.rbpf.grid = grid->settings();
    return std::make_unique<MapLocalizer>(
        wanted.filter, std::move(all), given.detector, threads,
        [&](const FilterSettings& filter, const DetectorTable& detectors, ThreadPool& pool) {
            return std::make_unique<localization::Localizer>(filter.rbpf, wanted.particles, pool,
                                                             make_strategies(filter, detectors), grid, start);
        });
}

std::shared_ptr<HeldTrajectory> trajectory_of(Run& run) {
    return run.with_filter([](const ParticleFilter& filter) {
        return std::make_shared<HeldTrajectory>(HeldTrajectory{filter.trajectory()});
    });
}

/// Feeds the scans of any iterable. Between scans, signals such as Ctrl-C are seen to.
std::shared_ptr<HeldTrajectory> run_over(Run& run, const py::iterable& scans, const py::object& on_update) {
    for (const py::handle scan : scans) {
        if (!py::isinstance<HeldScan>(scan)) {
            throw py::type_error("run: expected an iterable of ddtool.Scan; it has a " +
                                 py::repr(py::type::handle_of(scan)).cast<std::string>());
        }
        const auto update = run.update(scan.cast<const HeldScan&>());
        if (update && !on_update.is_none()) {
            on_update(update);
        }
        stop_if_asked();
    }
    return trajectory_of(run);
}

py::array_t<double> array_of(const Eigen::Matrix3d& matrix) {
    py::array_t<double> array({3, 3});
    for (py::ssize_t row = 0; row < 3; ++row) {
        for (py::ssize_t column = 0; column < 3; ++column) {
            array.mutable_at(row, column) = matrix(row, column);
        }
    }
    return array;
}

py::array_t<double> array_of(const Pose2& pose) {
    py::array_t<double> array(3);
    array.mutable_at(0) = pose.x_m;
    array.mutable_at(1) = pose.y_m;
    array.mutable_at(2) = pose.theta_rad;
    return array;
}

/// Lets Python's collector see the callable, which may own the object that asks it.
template <typename Type>
py::custom_type_setup seen_by_collector() {
    return py::custom_type_setup([](PyHeapTypeObject* heap_type) {
        PyTypeObject& type = heap_type->ht_type;
        type.tp_flags |= Py_TPFLAGS_HAVE_GC;
        type.tp_traverse = [](PyObject* self, visitproc visit, void* arg) -> int {
            Py_VISIT(Py_TYPE(self));
            auto* const instance = reinterpret_cast<py::detail::instance*>(self);
            const auto held = instance->get_value_and_holder();
            if (held.holder_constructed()) {
                if (const auto& detector = held.template holder<std::unique_ptr<Type>>()->callable()) {
                    Py_VISIT(detector->callable().ptr());
                }
            }
            return 0;
        };
        type.tp_clear = [](PyObject* self) -> int {
            auto* const instance = reinterpret_cast<py::detail::instance*>(self);
            const auto held = instance->get_value_and_holder();
            if (held.holder_constructed()) {
                if (const auto& detector = held.template holder<std::unique_ptr<Type>>()->callable()) {
                    detector->clear();
                }
            }
            return 0;
        };
    });
}

/// What Slam and Localizer have in common.
template <typename Type>
void add_run_members(py::class_<Type>& type) {
    type.def(
            "update", [](Type& run, const HeldScan& scan) { return run.update(scan); }, py::arg("scan"),
            R"(Takes the next scan; returns the Update, or None where the robot has hardly moved since the last one.

What the detector raises is raised here, after the update was completed with the degree 0; the next scan can follow.)")
        .def(
            "run",
            [](Type& run, const py::iterable& scans, const py::object& on_update) {
                return run_over(run, scans, on_update);
            },
            py::arg("scans"), py::kw_only(), py::arg("on_update") = py::none(),
            R"(Takes all scans of a Log, a Simulation or another iterable of Scan; returns the trajectory.

on_update: called with each Update. Ctrl-C ends the run between two scans; the path up to there stays.)")
        .def(
            "trajectory", [](Type& run) { return trajectory_of(run); },
            "A pose for every scan so far, from the past of the best particle. A copy, which later scans do not "
            "change.")
        .def(
            "map",
            [](Type& run) {
                return run.with_filter(
                    [](const ParticleFilter& filter) { return std::make_shared<HeldMap>(filter.map()); });
            },
            "The map of the best particle. A copy, which later scans do not change.")
        .def_property_readonly(
            "pose",
            [](Type& run) {
                return array_of(run.with_filter([](const ParticleFilter& filter) { return filter.pose(); }));
            },
            "(3,) world_from_robot at the latest scan: x and y in metres, heading in radians.")
        .def_property_readonly(
            "covariance",
            [](Type& run) {
                return array_of(run.with_filter([](const ParticleFilter& filter) { return filter.pose_covariance(); }));
            },
            "(3, 3) Covariance of pose, of x, y and heading in the world: m^2, m rad, rad^2.")
        .def_property_readonly(
            "settings", [](const Type& run) { return json_to_python(run.settings()); },
            "Every setting in effect, as config.json of a run has them. A callable is not among them.");
}

py::object standing_of(const HeldUpdate& held) { return held.standing ? py::cast(*held.standing) : py::none(); }

void add_update_class(py::module_& module) {
    py::class_<localization::Standing>(module, "Standing", "What a Localizer knows of being in the right place.")
        .def_readonly("probability", &localization::Standing::probability,
                      "That the robot is neither lost nor at one of the other places that fit.")
        .def_readonly("lost", &localization::Standing::lost,
                      "The probability that the map explains the scans nowhere where there are particles.")
        .def_readonly("mode_weight", &localization::Standing::mode_weight,
                      "Of the place of the pose among all places where there are particles.")
        .def_readonly("modes", &localization::Standing::modes, "The number of such places.")
        .def_readonly("particles", &localization::Standing::particles, "Their number before resampling.")
        .def_readonly("support", &localization::Standing::support,
                      "The share of the scan that the map explains at the pose.")
        .def_readonly("searched", &localization::Standing::searched,
                      "Whether the whole map was searched in this update.");
    const auto swarm = [](const std::shared_ptr<HeldUpdate>& held, const ParticleSnapshot& particles) {
        return std::make_shared<HeldSwarm>(std::shared_ptr<const ParticleSnapshot>(held, &particles));
    };
    py::class_<HeldUpdate, std::shared_ptr<HeldUpdate>>(module, "Update",
                                                        R"(What one update of the filter observed and did.

Arrays are read-only views of this update, which later updates do not change.)")
        .def_property_readonly(
            "stamp_ns", [](const HeldUpdate& held) { return held.update.matched.stamp_ns; },
            "Stamp of the scan in nanoseconds.")
        .def_property_readonly(
            "number", [](const HeldUpdate& held) { return held.update.matched.update; },
            "Number of updates before this one.")
        .def_property_readonly(
            "pose", [](const py::object& self) { return pose_view(self.cast<const HeldUpdate&>().update.pose, self); },
            "(3,) world_from_robot of the best particle: x and y in metres, heading in radians.")
        .def_property_readonly(
            "covariance",
            [](const py::object& self) {
                return view(self.cast<const HeldUpdate&>().update.covariance.data(), {3, 3},
                            {sizeof(double), 3 * sizeof(double)}, self);
            },
            "(3, 3) Covariance of pose, of x, y and heading in the world: m^2, m rad, rad^2.")
        .def_property_readonly(
            "degree", [](const HeldUpdate& held) { return held.update.degeneracy.degree; },
            "Degree of degeneracy: 0 where the scan determines the pose, 1 where it does not.")
        .def_property_readonly(
            "direction_rad", [](const HeldUpdate& held) { return held.direction_rad; },
            "The direction in the world in which the position is known least, in radians: the one that a callable "
            "detector gave in this update, else that in which the swarm spreads most.")
        .def_property_readonly(
            "swarm", [swarm](const std::shared_ptr<HeldUpdate>& held) { return swarm(held, held->update.matched); },
            "The Swarm after scan matching, as the detector got it.")
        .def_property_readonly(
            "corrected",
            [swarm](const std::shared_ptr<HeldUpdate>& held) { return swarm(held, held->update.corrected); },
            "The Swarm after the corrections of the method, before resampling.")
        .def_property_readonly(
            "resampled", [](const HeldUpdate& held) { return held.update.resampled; },
            "Whether the particles were resampled.")
        .def_property_readonly(
            "seconds", [](const HeldUpdate& held) { return held.update.times.total_s(); },
            "Wall time of the update in the filter.")
        .def_property_readonly("standing", &standing_of, "The Standing, if the update is of a Localizer; else None.")
        .def("__repr__", [](const HeldUpdate& held) {
            return "<ddtool.Update " + std::to_string(held.update.matched.update) + " degree " +
                   std::to_string(held.update.degeneracy.degree) + ">";
        });
}

}  // namespace

void add_runs(py::module_& module) {
    add_update_class(module);
    py::class_<Slam> slam(module, "Slam", R"(A particle filter that maps, as `ddtool slam` runs it.

The same settings, seed and scans give the same trajectory, to the byte, as the command, on any number of threads. Other
Python threads go on while it works. An object may be used by several threads, which then wait for each other.)",
                          seen_by_collector<Slam>());
    slam.def(py::init(&make_slam), py::arg("method") = py::none(), py::kw_only(), py::arg("particles") = py::none(),
             py::arg("seed") = py::none(), py::arg("detector") = py::none(), py::arg("settings") = py::none(),
             py::arg("threads") = 0,
             R"(method: one of methods(); "anti-degeneracy" if not given.
particles, seed: the number of particles, and the seed of all chance.
detector: a name of detectors(), a .safetensors file, or a callable that gets a Swarm and returns the degree of
    degeneracy from 0 to 1, or a tuple of it and a direction in radians; the method's own if not given.
settings: those of `ddtool slam` by their names in JSON, nested or with dots: {"filter.gate": "none"}. The arguments
    before come after them. The group "log" is for open_log() and has no effect here.
threads: 0 is one per core.)");
    add_run_members(slam);
    py::class_<MapLocalizer> localizer(
        module, "Localizer", "Follows a robot in a saved map, as `ddtool localize` does; localize() makes it.",
        seen_by_collector<MapLocalizer>());
    add_run_members(localizer);
    module.def("localize", &make_localizer, py::arg("map"), py::arg("initial_pose") = py::none(), py::kw_only(),
               py::arg("method") = py::none(), py::arg("particles") = py::none(), py::arg("seed") = py::none(),
               py::arg("detector") = py::none(), py::arg("settings") = py::none(), py::arg("threads") = 1,
               R"(A Localizer, to be given scans as Slam is.

map: the path of a map.ddmap of a run, of a map.yaml of map_server or nav2, or of a folder with either.
initial_pose: (3,), where the robot is at the first scan; if not given, the whole map is searched.
particles: the least number of them. The other arguments are as for Slam; settings are those of `ddtool localize`.)");
}

}  // namespace ddtool::python

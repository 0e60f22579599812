#include "swarm.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "arrays.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/methods/method.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "ddtool/swarm/swarm_shape.hpp"
#include "host.hpp"
#include "methods/settings_json.hpp"
#include "swarm/rules.hpp"
#include "swarm/weights.hpp"

namespace ddtool::python {
namespace {

using Poses = py::array_t<double, py::array::c_style>;

Poses poses_or_nothing(const py::object& value, py::ssize_t count, const std::string& name) {
    if (value.is_none()) {
        Poses zeros({count, py::ssize_t{3}});
        std::fill_n(zeros.mutable_data(), zeros.size(), 0.0);
        return zeros;
    }
    const std::string form = "an array of shape (" + std::to_string(count) + ", 3)";
    Poses poses = numbers_from(value, 2, 3, name, form);
    if (poses.shape(0) != count) {
        throw UsageError(name + ": expected " + form + ", as many rows as poses");
    }
    return poses;
}

/// A number per particle.
std::vector<double> numbers_of(const py::object& value, py::ssize_t count, double otherwise, const std::string& name) {
    if (value.is_none()) {
        std::vector<double> same(static_cast<std::size_t>(count), otherwise);
        return same;
    }
    const std::string form = "an array of shape (" + std::to_string(count) + ",)";
    const auto numbers = numbers_from(value, 1, 0, name, form);
    if (numbers.shape(0) != count) {
        throw UsageError(name + ": expected " + form + ", as many entries as poses");
    }
    return {numbers.data(), numbers.data() + count};
}

Pose2 row_of(const Poses& poses, py::ssize_t row) { return {poses.at(row, 0), poses.at(row, 1), poses.at(row, 2)}; }

std::shared_ptr<HeldSwarm> made_swarm(const py::object& poses, const py::object& matched_motions,
                                      const py::object& predicted_motions, const py::object& weights,
                                      const py::object& log_likelihoods, const py::object& odometry_motion) {
    const Poses places = numbers_from(poses, 2, 3, "poses", "an array of shape (particles, 3)");
    const py::ssize_t count = places.shape(0);
    const Poses matched = poses_or_nothing(matched_motions, count, "matched_motions");
    const Poses predicted = poses_or_nothing(predicted_motions, count, "predicted_motions");
    std::vector<double> shares = numbers_of(weights, count, 1.0, "weights");
    const std::vector<double> likelihoods = numbers_of(log_likelihoods, count, 0.0, "log_likelihoods");
    double sum = 0.0;
    for (const double share : shares) {
        if (!(share >= 0.0 && share < INFINITY)) {
            throw UsageError("weights: expected finite numbers from 0 up");
        }
        sum += share;
    }
    if (count > 0 && !(sum > 0.0)) {
        throw UsageError("weights: expected at least one above 0");
    }
    auto swarm = std::make_shared<ParticleSnapshot>();
    swarm->odometry_motion = odometry_motion.is_none() ? Pose2{} : pose_from(odometry_motion, "odometry_motion");
    for (py::ssize_t row = 0; row < count; ++row) {
        const auto at = static_cast<std::size_t>(row);
        swarm->particles.push_back({.pose = row_of(places, row),
                                    .matched_motion = row_of(matched, row),
                                    .predicted_motion = row_of(predicted, row),
                                    .log_likelihood = likelihoods[at],
                                    .weight = shares[at] / sum});
    }
    return std::make_shared<HeldSwarm>(swarm);
}

py::array particle_numbers(const py::object& self, double SnapshotParticle::*member) {
    return column_view(self.cast<const HeldSwarm&>().particles, member, self);
}

py::array particle_poses(const py::object& self, Pose2 SnapshotParticle::*member) {
    return pose_column_view(self.cast<const HeldSwarm&>().particles, member, self);
}

py::array all_numbers(const py::object& self) {
    constexpr py::ssize_t columns = sizeof(SnapshotParticle) / sizeof(double);
    const std::span<const SnapshotParticle> particles = self.cast<const HeldSwarm&>().particles;
    const double* const first = particles.empty() ? nullptr : &particles.front().pose.x_m;
    return view(first, {static_cast<py::ssize_t>(particles.size()), columns},
                {sizeof(SnapshotParticle), sizeof(double)}, self);
}

Pose2 SnapshotParticle::*positions_named(const std::string& positions) {
    if (positions == "poses") {
        return &SnapshotParticle::pose;
    }
    if (positions == "matched_motions") {
        return &SnapshotParticle::matched_motion;
    }
    if (positions == "predicted_motions") {
        return &SnapshotParticle::predicted_motion;
    }
    throw UsageError("positions: expected poses, matched_motions or predicted_motions, not '" + positions + "'");
}

/// A detector of the library, to be asked from Python. The mutex is there because a network has working memory.
class NamedDetector {
public:
    NamedDetector(std::string name, const FilterSettings& settings)
        : name_(std::move(name)),
          detector_(DetectorTable().make(expect_model_file(name_), settings.method.detection, settings.rbpf.motion)) {}

    double ask(const HeldSwarm& swarm) {
        const std::lock_guard lock(mutex_);
        return detector_ ? detector_(swarm.snapshot()).degree : 0.0;
    }
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    std::string name_;
    DegeneracyDetector detector_;
    std::mutex mutex_;
};

ImageSettings image_settings(const std::string& detector, const std::optional<py::dict>& settings) {
    Json json = image_seen_natively(expect_model_file(detector));
    merge_dict(json, settings);
    const ImageSettings image = json.get<ImageSettings>();
    expect_valid(image);
    return image;
}

py::array_t<std::uint8_t> render(const HeldSwarm& swarm, const std::string& detector,
                                 const std::optional<py::dict>& settings) {
    ParticleRenderer renderer(image_settings(detector, settings));
    const auto side = static_cast<py::ssize_t>(renderer.settings().size_px);
    py::array_t<std::uint8_t> image({side, side});
    const std::span<std::uint8_t> pixels(image.mutable_data(), static_cast<std::size_t>(image.size()));
    without_gil([&] { renderer.render(swarm.particles, pixels); });
    return image;
}

py::tuple state_of(const HeldSwarm& swarm) {
    const auto* const bytes = reinterpret_cast<const char*>(swarm.particles.data());
    const Pose2& motion = swarm.odometry_motion;
    return py::make_tuple(py::bytes(bytes, swarm.particles.size_bytes()), swarm.stamp_ns, swarm.update, motion.x_m,
                          motion.y_m, motion.theta_rad);
}

std::shared_ptr<HeldSwarm> swarm_of_state(const py::tuple& state) {
    const auto bytes = state[0].cast<std::string>();
    if (state.size() != 6 || bytes.size() % sizeof(SnapshotParticle) != 0) {
        throw UsageError("a pickled Swarm: damaged");
    }
    auto swarm = std::make_shared<ParticleSnapshot>();
    swarm->particles.resize(bytes.size() / sizeof(SnapshotParticle));
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<char*>(swarm->particles.data()));
    swarm->stamp_ns = state[1].cast<std::int64_t>();
    swarm->update = state[2].cast<std::uint64_t>();
    swarm->odometry_motion = {state[3].cast<double>(), state[4].cast<double>(), state[5].cast<double>()};
    return std::make_shared<HeldSwarm>(swarm);
}

void add_swarm_class(py::module_& module) {
    py::class_<HeldSwarm, std::shared_ptr<HeldSwarm>>(module, "Swarm", R"(The particles of one update.

It is what a detector sees: the swarm after scan matching and before resampling. All arrays are read-only views of its
memory, nothing is copied, and a view keeps that memory alive. Poses are x and y in metres and the heading in radians.)")
        .def(py::init(&made_swarm), py::arg("poses"), py::kw_only(), py::arg("matched_motions") = py::none(),
             py::arg("predicted_motions") = py::none(), py::arg("weights") = py::none(),
             py::arg("log_likelihoods") = py::none(), py::arg("odometry_motion") = py::none(),
             R"(A swarm of one's own, for example from another particle filter.

poses: (N, 3), world_from_robot of each particle.
matched_motions, predicted_motions: (N, 3), the motion since the last update in the robot's frame at that update, after
    and before scan matching; zero if not given.
weights: (N,), from 0 up; scaled to sum to 1; equal if not given.
log_likelihoods: (N,); zero if not given.
odometry_motion: (3,), the motion without noise since the last update; zero if not given.)")
        .def("__len__", [](const HeldSwarm& swarm) { return swarm.particles.size(); })
        .def("__repr__",
             [](const HeldSwarm& swarm) {
                 return "<ddtool.Swarm of " + std::to_string(swarm.particles.size()) + " particles, update " +
                        std::to_string(swarm.update) + ">";
             })
        .def_property_readonly(
            "stamp_ns", [](const HeldSwarm& swarm) { return swarm.stamp_ns; }, "Stamp of the scan in nanoseconds.")
        .def_property_readonly(
            "update", [](const HeldSwarm& swarm) { return swarm.update; },
            "Number of updates of the filter before this one.")
        .def_property_readonly(
            "odometry_motion",
            [](const py::object& self) { return pose_view(self.cast<const HeldSwarm&>().odometry_motion, self); },
            "(3,) The odometry's motion without noise since the last update, in the robot's frame at that update.")
        .def_property_readonly(
            "poses", [](const py::object& self) { return particle_poses(self, &SnapshotParticle::pose); },
            "(N, 3) world_from_robot of each particle, after scan matching.")
        .def_property_readonly(
            "matched_motions",
            [](const py::object& self) { return particle_poses(self, &SnapshotParticle::matched_motion); },
            "(N, 3) Motion since the last update after scan matching, in the robot's frame at that update.")
        .def_property_readonly(
            "predicted_motions",
            [](const py::object& self) { return particle_poses(self, &SnapshotParticle::predicted_motion); },
            "(N, 3) The same before scan matching, as it was drawn from the odometry's noise.")
        .def_property_readonly(
            "log_likelihoods",
            [](const py::object& self) { return particle_numbers(self, &SnapshotParticle::log_likelihood); },
            "(N,) Log-likelihood accumulated since the last resampling.")
        .def_property_readonly(
            "log_likelihood_increments",
            [](const py::object& self) { return particle_numbers(self, &SnapshotParticle::log_likelihood_increment); },
            "(N,) Log-likelihood of this update alone.")
        .def_property_readonly(
            "match_scores",
            [](const py::object& self) { return particle_numbers(self, &SnapshotParticle::match_score); },
            "(N,) Mean score of the beams, from 0 to 1.")
        .def_property_readonly(
            "weights", [](const py::object& self) { return particle_numbers(self, &SnapshotParticle::weight); },
            "(N,) Normalised weights; they sum to 1.")
        .def_property_readonly("particles", &all_numbers,
                               "(N, 13) All of the above, a particle per row, in the columns of the data sets' files.")
        .def_property_readonly(
            "effective_size",
            [](const HeldSwarm& swarm) {
                return swarm.particles.empty() ? 0.0 : effective_sample_size(weights_of(swarm.particles));
            },
            "Effective sample size: how many particles carry the weight, from 1 to N.")
        .def_property_readonly(
            "dispersion",
            [](const HeldSwarm& swarm) { return dispersion(swarm.particles, &SnapshotParticle::log_likelihood); },
            "The paper's R: variance over magnitude of the mean of the log-likelihoods.")
        .def(
            "shape",
            [](const HeldSwarm& swarm, const std::string& positions) {
                const SwarmShape shape = swarm_shape(swarm.particles, positions_named(positions));
                return py::make_tuple(shape.major_sd_m(), shape.minor_sd_m(), shape.major_direction_rad);
            },
            py::arg("positions") = "poses",
            R"(The weighted spread of the positions: (major_sd_m, minor_sd_m, major_direction_rad).

positions: "poses", "matched_motions" or "predicted_motions". The direction is in the frame of these: the world for
poses, the robot's at the last update for motions; in radians, from -pi/2 to pi/2.)")
        .def(py::pickle(&state_of, &swarm_of_state));
}

void add_detector_class(py::module_& module) {
    py::class_<NamedDetector, std::shared_ptr<NamedDetector>>(
        module, "Detector", R"(A detector of the library by name, or a network in a .safetensors file.

Calling it with a Swarm gives the degree of degeneracy. It is asked as it is, without the gate that a filter puts before
it ("filter.gate").)")
        .def(py::init([](const std::string& name, const std::optional<py::dict>& settings) {
                 Json json{{"filter", filter_settings_json({})}};
                 merge_dict(json, settings);
                 return std::make_shared<NamedDetector>(name, filter_settings_from_json(json.at("filter")));
             }),
             py::arg("name"), py::kw_only(), py::arg("settings") = py::none(),
             R"(name: one of detectors(), or a .safetensors file. settings: those of the group "filter".)")
        .def_property_readonly("name", &NamedDetector::name, "The name or file that it was made from.")
        .def(
            "__call__",
            [](NamedDetector& detector, const HeldSwarm& swarm) {
                return without_gil([&] { return detector.ask(swarm); });
            },
            py::arg("swarm"), "The degree of degeneracy: 0 where the scan determines the pose, 1 where it does not.")
        .def("__repr__", [](const NamedDetector& detector) { return "<ddtool.Detector '" + detector.name() + "'>"; });
}

}  // namespace

void add_swarms(py::module_& module) {
    add_swarm_class(module);
    add_detector_class(module);
    module.def(
        "detectors", [] { return DetectorTable().names(); }, "The names of the detectors.");
    module.def("methods", &method_names, "The names of the methods of the filter.");
    module.def("render", &render, py::arg("swarm"), py::kw_only(), py::arg("detector") = shipped_model_name,
               py::arg("settings") = py::none(),
               R"(The swarm as the image that a network reads: (S, S) uint8, 0 or 255, rows from the top.

detector: the network whose images are drawn: a name of detectors() or a .safetensors file.
settings: changes to the settings of these images, such as {"size_px": 64}; docs/imaging.md explains them.)");
}

}  // namespace ddtool::python

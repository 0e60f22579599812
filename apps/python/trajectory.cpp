#include "trajectory.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "ddtool/base/error.hpp"
#include "host.hpp"
#include "scores/trajectory_score.hpp"
#include "scores/tum_file.hpp"

namespace ddtool::python {
namespace {

using Holder = std::shared_ptr<HeldTrajectory>;

std::span<const StampedPose> rows_of(const py::object& self) { return self.cast<const HeldTrajectory&>().poses; }

Holder made_trajectory(const py::object& stamps_ns, const py::object& poses) {
    using Stamps = py::array_t<std::int64_t, py::array::c_style>;
    const py::object given = py::module_::import("numpy").attr("asarray")(stamps_ns);
    // No conversion of other types: as float64, stamps of today lose hundreds of nanoseconds.
    if (given.attr("dtype").attr("kind").cast<std::string>().find_first_of("iu") == std::string::npos) {
        throw UsageError("stamps_ns: expected whole numbers of nanoseconds, shape (poses,)");
    }
    const auto stamps = given.attr("astype")("int64").cast<Stamps>();
    if (!py::module_::import("numpy").attr("array_equal")(stamps, given).cast<bool>()) {
        throw UsageError("stamps_ns: expected numbers below 2^63");
    }
    const auto rows = numbers_from(poses, 2, 3, "poses", "an array of shape (poses, 3)");
    if (stamps.ndim() != 1 || stamps.shape(0) != rows.shape(0)) {
        throw UsageError("stamps_ns: expected shape (" + std::to_string(rows.shape(0)) + ",), a stamp for each pose");
    }
    if (!std::all_of(rows.data(), rows.data() + rows.size(), [](double number) { return std::isfinite(number); })) {
        throw UsageError("poses: expected finite numbers");
    }
    auto made = std::make_shared<HeldTrajectory>();
    for (py::ssize_t row = 0; row < rows.shape(0); ++row) {
        made->poses.push_back({stamps.at(row), {rows.at(row, 0), rows.at(row, 1), rows.at(row, 2)}});
    }
    return made;
}

py::tuple state_of_trajectory(const HeldTrajectory& held) {
    static_assert(std::is_trivially_copyable_v<StampedPose>);
    return py::make_tuple(
        py::bytes(reinterpret_cast<const char*>(held.poses.data()), held.poses.size() * sizeof(StampedPose)));
}

Holder trajectory_of_state(const py::tuple& state) {
    const auto bytes = state[0].cast<std::string>();
    auto made = std::make_shared<HeldTrajectory>();
    made->poses.resize(bytes.size() / sizeof(StampedPose));
    std::copy_n(bytes.begin(), made->poses.size() * sizeof(StampedPose), reinterpret_cast<char*>(made->poses.data()));
    return made;
}

std::string path_text(const py::object& path) {
    return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

/// A score with the errors behind its figures.
struct HeldScore {
    TrajectoryScore score;
    ScoreFigures figures;
    std::vector<std::int64_t> stamps_ns;
};

std::shared_ptr<HeldScore> score(const py::object& estimate, const py::object& truth, const py::object& relations,
                                 const std::string& align, double max_time_difference_s, double rpe_delta,
                                 const std::string& rpe_unit) {
    if (truth.is_none() && relations.is_none()) {
        throw UsageError("score: expected truth, relations or both");
    }
    if (!(max_time_difference_s >= 0.0)) {
        throw UsageError("max_time_difference_s: expected a number of seconds, 0 or more");
    }
    const ScoreOptions options{
        .ate = {.alignment = parse_alignment(align), .max_time_difference_s = max_time_difference_s},
        .rpe_delta = {.value = rpe_delta, .unit = parse_delta_unit(rpe_unit)}};
    const Trajectory path = trajectory_from(estimate);
    const std::optional<Trajectory> reference = truth.is_none() ? std::nullopt : std::optional(trajectory_from(truth));
    const std::optional<std::vector<Relation>> motions =
        relations.is_none() ? std::nullopt : std::optional(read_relations(existing_path(relations)));
    auto held = std::make_shared<HeldScore>();
    without_gil([&] {
        if (reference) {
            held->score = score_against(path, *reference, options);
        }
        if (motions) {
            held->score.relations = score_relations(path, *motions, max_time_difference_s);
        }
        held->figures = figures_of(held->score);
    });
    if (held->score.relations && held->score.relations->skipped == motions->size()) {
        throw Error("score: none of the " + std::to_string(motions->size()) +
                    " relations has both times in the trajectory");
    }
    if (held->score.absolute) {
        for (const PosePair& pair : held->score.absolute->pairs) {
            held->stamps_ns.push_back(pair.stamp_ns);
        }
    }
    return held;
}

void add_statistics(py::module_& module) {
    py::class_<ErrorStatistics>(module, "Statistics", "Statistics of errors, in the unit of the errors.")
        .def_readonly("count", &ErrorStatistics::count, "How many errors.")
        .def_readonly("rmse", &ErrorStatistics::rmse, "Root of the mean of their squares.")
        .def_readonly("mean", &ErrorStatistics::mean, "Their mean.")
        .def_readonly("median", &ErrorStatistics::median, "Their median.")
        .def_readonly("std", &ErrorStatistics::std, "Their standard deviation about the mean.")
        .def_readonly("min", &ErrorStatistics::min, "The least.")
        .def_readonly("max", &ErrorStatistics::max, "The largest.")
        .def("__repr__", [](const ErrorStatistics& statistics) {
            return "<ddtool.Statistics rmse=" + std::to_string(statistics.rmse) +
                   " count=" + std::to_string(statistics.count) + ">";
        });
}

using FigureMember = std::optional<ErrorStatistics> ScoreFigures::*;

void add_score_class(py::module_& module) {
    py::class_<HeldScore, std::shared_ptr<HeldScore>> type(
        module, "Score", "Errors of a trajectory; docs/scoring.md defines them. A figure without its truth is None.");
    const auto figure = [&type](const char* name, FigureMember member, const char* doc) {
        type.def_property_readonly(
            name, [member](const HeldScore& held) { return held.figures.*member; }, doc);
    };
    figure("ate_m", &ScoreFigures::ate_m, "Absolute trajectory error, in metres.");
    figure("error_x_m", &ScoreFigures::error_x_m, "Its part along x, in metres.");
    figure("error_y_m", &ScoreFigures::error_y_m, "Its part along y, in metres.");
    figure("rpe_m", &ScoreFigures::rpe_m, "Relative pose error, position, in metres.");
    figure("rpe_deg", &ScoreFigures::rpe_deg, "Relative pose error, heading, in degrees.");
    figure("relations_m", &ScoreFigures::relations_m, "Errors of the relations, position, in metres.");
    figure("relations_deg", &ScoreFigures::relations_deg, "Errors of the relations, heading, in degrees.");
    figure("relations_short_m", &ScoreFigures::relations_short_m, "Those of relations over less than 5 s.");
    figure("relations_short_deg", &ScoreFigures::relations_short_deg, "Those of relations over less than 5 s.");
    figure("relations_long_m", &ScoreFigures::relations_long_m, "Those of relations over more than 60 s.");
    figure("relations_long_deg", &ScoreFigures::relations_long_deg, "Those of relations over more than 60 s.");
    type.def_property_readonly(
            "relations_skipped", [](const HeldScore& held) { return held.figures.relations_skipped; },
            "How many relations have a time for which the trajectory has no pose.")
        .def_property_readonly(
            "truth_from_estimate",
            [](const py::object& self) -> py::object {
                const auto& pose = self.cast<const HeldScore&>().figures.reference_from_estimate;
                return pose ? py::object(pose_view(*pose, self)) : py::none();
            },
            "(3,) The motion by which the estimate was moved first.")
        .def_property_readonly(
            "errors_m",
            [](const py::object& self) {
                const auto& absolute = self.cast<const HeldScore&>().score.absolute;
                return view(absolute ? std::span<const double>(absolute->errors_m) : std::span<const double>(), self);
            },
            "(M,) The distance of each pair of poses, in metres, behind ate_m.")
        .def_property_readonly(
            "stamps_ns",
            [](const py::object& self) {
                return view(std::span<const std::int64_t>(self.cast<const HeldScore&>().stamps_ns), self);
            },
            "(M,) int64, the stamps of these pairs in nanoseconds.")
        .def(
            "as_dict", [](const HeldScore& held) { return json_to_python(score_json(held.score)); },
            "The figures as `ddtool score --json` prints them.")
        .def("__repr__", [](const HeldScore& held) {
            const auto& ate = held.figures.ate_m;
            return ate ? "<ddtool.Score ATE " + std::to_string(ate->rmse) + " m>" : std::string("<ddtool.Score>");
        });
}

}  // namespace

Trajectory trajectory_from(const py::object& value) {
    if (py::isinstance<HeldTrajectory>(value)) {
        return value.cast<const HeldTrajectory&>().poses;
    }
    if (py::isinstance<py::str>(value) || py::hasattr(value, "__fspath__")) {
        const std::filesystem::path path = existing_path(value);
        return read_tum(path);
    }
    throw py::type_error("expected a ddtool.Trajectory or the path of a TUM file, not " +
                         py::repr(py::type::of(value)).cast<std::string>());
}

void add_trajectories(py::module_& module) {
    py::class_<HeldTrajectory, Holder>(module, "Trajectory", R"(Poses over time, in the order in which they were passed.

Its arrays are read-only views of its memory. Stamps usually rise, but in some old logs they step back.)")
        .def(py::init(&made_trajectory), py::arg("stamps_ns"), py::arg("poses"),
             "stamps_ns: (N,) whole nanoseconds. poses: (N, 3), x and y in metres and the heading in radians.")
        .def_static(
            "read",
            [](const py::object& path) {
                return std::make_shared<HeldTrajectory>(HeldTrajectory{read_tum(existing_path(path))});
            },
            py::arg("path"), "Reads a TUM file.")
        .def(
            "write",
            [](const HeldTrajectory& held, const py::object& path) {
                const std::string file = path_text(path);
                without_gil([&] { write_tum(file, held.poses); });
            },
            py::arg("path"), "Writes a TUM file, with the same bytes as `ddtool slam` writes for the same poses.")
        .def_property_readonly(
            "stamps_ns",
            [](const py::object& self) { return column_view(rows_of(self), &StampedPose::stamp_ns, self); },
            "(N,) int64, nanoseconds.")
        .def_property_readonly(
            "poses", [](const py::object& self) { return pose_column_view(rows_of(self), &StampedPose::pose, self); },
            "(N, 3) world_from_robot: x and y in metres, heading in radians.")
        .def_property_readonly(
            "length_m", [](const HeldTrajectory& held) { return path_length_m(held.poses); },
            "Length of the path in metres.")
        .def("__len__", [](const HeldTrajectory& held) { return held.poses.size(); })
        .def("__repr__",
             [](const HeldTrajectory& held) {
                 return "<ddtool.Trajectory of " + std::to_string(held.poses.size()) + " poses>";
             })
        .def(py::pickle(&state_of_trajectory, &trajectory_of_state));
    add_statistics(module);
    add_score_class(module);
    module.def("score", &score, py::arg("estimate"), py::arg("truth") = py::none(), py::arg("relations") = py::none(),
               py::kw_only(), py::arg("align") = "se2",
               py::arg("max_time_difference_s") = default_max_time_difference_s, py::arg("rpe_delta") = 1.0,
               py::arg("rpe_unit") = "frames",
               R"(The errors of a trajectory, as `ddtool score` computes them.

estimate, truth: each a Trajectory or the path of a TUM file.
relations: the path of a file of relations. At least one of truth and relations is needed.
align: the motion granted to the estimate first: "none", "first" or "se2".
max_time_difference_s: stamps at most so far apart are one moment.
rpe_delta, rpe_unit: how far apart the two poses of an RPE are: "frames", "metres" or "seconds".)");
}

}  // namespace ddtool::python

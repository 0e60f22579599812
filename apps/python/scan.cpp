#include "scan.hpp"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "ddtool/base/error.hpp"

namespace ddtool::python {
namespace {

const char* name_of_step(OdometryStep step) {
    switch (step) {
        case OdometryStep::measured:
            return "measured";
        case OdometryStep::guessed:
            return "guessed";
        case OdometryStep::unknown:
            break;
    }
    return "unknown";
}

double finite(double value, const char* name) {
    if (!std::isfinite(value)) {
        throw UsageError(std::string(name) + ": expected a finite number");
    }
    return value;
}

std::shared_ptr<HeldScan> made_scan(const py::object& ranges, double angle_min_rad, double angle_increment_rad,
                                    double range_max_m, std::int64_t stamp_ns, const py::object& odom_from_robot,
                                    const py::object& robot_from_laser, const py::object& world_from_robot,
                                    double range_min_m, double scan_time_s) {
    const auto values = numbers_from(ranges, 1, 0, "ranges", "an array of shape (beams,), in metres");
    auto scan = std::make_shared<HeldScan>();
    LaserScan& beams = scan->frame.scan;
    beams.stamp_ns = stamp_ns;
    beams.angle_min_rad = finite(angle_min_rad, "angle_min_rad");
    beams.angle_increment_rad = finite(angle_increment_rad, "angle_increment_rad");
    beams.scan_time_s = finite(scan_time_s, "scan_time_s");
    beams.range_min_m = finite(range_min_m, "range_min_m");
    beams.range_max_m = finite(range_max_m, "range_max_m");
    if (!(range_min_m >= 0.0 && range_max_m > range_min_m)) {
        throw UsageError("range_max_m: expected more than range_min_m, and that from 0 up");
    }
    beams.ranges_m.reserve(static_cast<std::size_t>(values.size()));
    std::transform(values.data(), values.data() + values.size(), std::back_inserter(beams.ranges_m),
                   [](double range_m) { return static_cast<float>(range_m); });
    normalise_ranges(beams);
    SensorFrame& frame = scan->frame;
    frame.robot_from_laser = pose_from(robot_from_laser, "robot_from_laser");
    if (odom_from_robot.is_none()) {
        frame.odom_step = OdometryStep::unknown;
    } else {
        frame.odom_from_robot = pose_from(odom_from_robot, "odom_from_robot");
    }
    if (!world_from_robot.is_none()) {
        frame.world_from_robot = pose_from(world_from_robot, "world_from_robot");
    }
    return scan;
}

const SensorFrame& frame_of(const py::object& self) { return self.cast<const HeldScan&>().frame; }

py::array_t<double> angles_of(const HeldScan& held) {
    const LaserScan& scan = held.frame.scan;
    py::array_t<double> angles(static_cast<py::ssize_t>(scan.ranges_m.size()));
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
        angles.mutable_data()[beam] = scan.angle_rad(beam);
    }
    return angles;
}

py::array_t<double> points_of(const HeldScan& held) {
    const LaserScan& scan = held.frame.scan;
    std::vector<double> points;
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); ++beam) {
        const double range_m = scan.ranges_m[beam];
        if (std::isfinite(range_m)) {
            const double angle_rad = scan.angle_rad(beam);
            const Point2 point =
                held.frame.robot_from_laser * Point2{range_m * std::cos(angle_rad), range_m * std::sin(angle_rad)};
            points.insert(points.end(), {point.x_m, point.y_m});
        }
    }
    py::array_t<double> array({static_cast<py::ssize_t>(points.size() / 2), py::ssize_t{2}});
    std::copy(points.begin(), points.end(), array.mutable_data());
    return array;
}

py::list joined_of(const std::shared_ptr<HeldScan>& held) {
    py::list joined;
    for (const SensorFrame& frame : held->frame.joined) {
        joined.append(std::make_shared<HeldScan>(HeldScan{frame}));
    }
    return joined;
}

py::tuple pose_state(const Pose2& pose) { return py::make_tuple(pose.x_m, pose.y_m, pose.theta_rad); }
Pose2 pose_of_state(const py::handle& state) { return pose_from(py::reinterpret_borrow<py::object>(state), "a pose"); }

py::tuple frame_state(const SensorFrame& frame) {
    const LaserScan& scan = frame.scan;
    py::list sweep;
    for (const Pose2& pose : frame.sweep) {
        sweep.append(pose_state(pose));
    }
    py::list joined;
    for (const SensorFrame& other : frame.joined) {
        joined.append(frame_state(other));
    }
    const py::object truth = frame.world_from_robot ? py::object(pose_state(*frame.world_from_robot)) : py::none();
    return py::make_tuple(
        scan.stamp_ns, scan.angle_min_rad, scan.angle_increment_rad, scan.time_increment_s, scan.scan_time_s,
        scan.range_min_m, scan.range_max_m,
        py::bytes(reinterpret_cast<const char*>(scan.ranges_m.data()), scan.ranges_m.size() * sizeof(float)),
        pose_state(frame.robot_from_laser), pose_state(frame.odom_from_robot), truth, static_cast<int>(frame.odom_step),
        sweep, frame.lidar, joined);
}

SensorFrame frame_of_state(const py::tuple& state) {
    SensorFrame frame;
    LaserScan& scan = frame.scan;
    scan.stamp_ns = state[0].cast<std::int64_t>();
    scan.angle_min_rad = state[1].cast<double>();
    scan.angle_increment_rad = state[2].cast<double>();
    scan.time_increment_s = state[3].cast<double>();
    scan.scan_time_s = state[4].cast<double>();
    scan.range_min_m = state[5].cast<double>();
    scan.range_max_m = state[6].cast<double>();
    const auto ranges = state[7].cast<std::string>();
    scan.ranges_m.resize(ranges.size() / sizeof(float));
    std::copy_n(ranges.begin(), scan.ranges_m.size() * sizeof(float), reinterpret_cast<char*>(scan.ranges_m.data()));
    frame.robot_from_laser = pose_of_state(state[8]);
    frame.odom_from_robot = pose_of_state(state[9]);
    if (!state[10].is_none()) {
        frame.world_from_robot = pose_of_state(state[10]);
    }
    frame.odom_step = static_cast<OdometryStep>(std::clamp(state[11].cast<int>(), 0, 2));
    for (const py::handle pose : state[12]) {
        frame.sweep.push_back(pose_of_state(pose));
    }
    frame.lidar = state[13].cast<std::size_t>();
    for (const py::handle other : state[14]) {
        frame.joined.push_back(frame_of_state(py::reinterpret_borrow<py::tuple>(other)));
    }
    return frame;
}

py::tuple state_of_scan(const HeldScan& held) {
    py::list information;
    if (held.fisher_information) {
        for (const double entry : held.fisher_information->reshaped()) {
            information.append(entry);
        }
    }
    return py::make_tuple(frame_state(held.frame), information);
}

std::shared_ptr<HeldScan> scan_of_state(const py::tuple& state) {
    auto held = std::make_shared<HeldScan>(HeldScan{frame_of_state(state[0].cast<py::tuple>())});
    const auto information = state[1].cast<std::vector<double>>();
    if (information.size() == 9) {
        held->fisher_information = Eigen::Map<const Eigen::Matrix3d>(information.data());
    }
    return held;
}

}  // namespace

void add_scans(py::module_& module) {
    py::class_<HeldScan, std::shared_ptr<HeldScan>>(module, "Scan", R"(One turn of a 2-D lidar, with the odometry.

Poses are arrays of x and y in metres and the heading in radians. A name such as odom_from_robot is the pose of the robot
in the odometry's frame. Arrays are read-only views; nothing is copied.)")
        .def(py::init(&made_scan), py::arg("ranges"), py::kw_only(), py::arg("angle_min_rad"),
             py::arg("angle_increment_rad"), py::arg("range_max_m"), py::arg("stamp_ns"),
             py::arg("odom_from_robot") = py::none(), py::arg("robot_from_laser") = py::make_tuple(0.0, 0.0, 0.0),
             py::arg("world_from_robot") = py::none(), py::arg("range_min_m") = 0.0, py::arg("scan_time_s") = 0.0,
             R"(A scan of one's own. All its beams count as measured at the stamp.

ranges: (B,) in metres. inf, and what is above range_max_m, is no return; NaN, and what is below range_min_m, is invalid.
angle_min_rad, angle_increment_rad: beam i points at angle_min_rad + i * angle_increment_rad, counter-clockwise from the
    laser's x axis.
stamp_ns: in nanoseconds.
odom_from_robot: (3,); None where there is no odometry: the motion is then worked out from the scans.
robot_from_laser: (3,), where the lidar is on the robot.
world_from_robot: (3,), the true pose where it is known. The filter does not see it.)")
        .def("__len__", [](const HeldScan& held) { return held.frame.scan.ranges_m.size(); })
        .def("__repr__",
             [](const HeldScan& held) {
                 return "<ddtool.Scan of " + std::to_string(held.frame.scan.ranges_m.size()) + " beams at " +
                        std::to_string(held.frame.scan.stamp_ns) + " ns>";
             })
        .def_property_readonly(
            "stamp_ns", [](const HeldScan& held) { return held.frame.scan.stamp_ns; },
            "Stamp of the first beam in nanoseconds.")
        .def_property_readonly(
            "ranges",
            [](const py::object& self) { return view(std::span<const float>(frame_of(self).scan.ranges_m), self); },
            "(B,) float32, metres; inf is no return, NaN is invalid.")
        .def_property_readonly(
            "angles_rad", &angles_of,
            "(B,) The direction of each beam, counter-clockwise from the laser's x axis; a new array.")
        .def_property_readonly(
            "angle_min_rad", [](const HeldScan& held) { return held.frame.scan.angle_min_rad; },
            "Direction of the first beam in radians.")
        .def_property_readonly(
            "angle_increment_rad", [](const HeldScan& held) { return held.frame.scan.angle_increment_rad; },
            "From one beam to the next, in radians; negative for a lidar that turns clockwise.")
        .def_property_readonly(
            "time_increment_s", [](const HeldScan& held) { return held.frame.scan.time_increment_s; },
            "From one beam to the next, in seconds; 0 where unknown.")
        .def_property_readonly(
            "scan_time_s", [](const HeldScan& held) { return held.frame.scan.scan_time_s; },
            "From one scan to the next, in seconds; 0 where unknown.")
        .def_property_readonly(
            "range_min_m", [](const HeldScan& held) { return held.frame.scan.range_min_m; },
            "The least range that is measured, in metres.")
        .def_property_readonly(
            "range_max_m", [](const HeldScan& held) { return held.frame.scan.range_max_m; },
            "The largest range that is measured, in metres.")
        .def_property_readonly(
            "robot_from_laser", [](const py::object& self) { return pose_view(frame_of(self).robot_from_laser, self); },
            "(3,) The pose of the lidar on the robot.")
        .def_property_readonly(
            "odom_from_robot", [](const py::object& self) { return pose_view(frame_of(self).odom_from_robot, self); },
            "(3,) The odometry at the stamp.")
        .def_property_readonly(
            "odom_step", [](const HeldScan& held) { return name_of_step(held.frame.odom_step); },
            "What the odometry says of the motion since the scan before: \"measured\", \"guessed\" where it has a gap, "
            "or "
            "\"unknown\".")
        .def_property_readonly(
            "world_from_robot",
            [](const py::object& self) -> py::object {
                const auto& pose = frame_of(self).world_from_robot;
                return pose ? py::object(pose_view(*pose, self)) : py::none();
            },
            "(3,) The true pose, or None where it is not known.")
        .def_property_readonly(
            "lidar", [](const HeldScan& held) { return held.frame.lidar; }, "Which of the robot's lidars, from 0.")
        .def_property_readonly("joined", &joined_of,
                               "Copies of the scans of other lidars that are used together with this one.")
        .def_property_readonly(
            "fisher_information",
            [](const py::object& self) -> py::object {
                const auto& information = self.cast<const HeldScan&>().fisher_information;
                return information
                           ? py::object(view(information->data(), {3, 3}, {sizeof(double), 3 * sizeof(double)}, self))
                           : py::none();
            },
            "(3, 3) What the scan tells of (x, y, heading) in the robot's frame, in 1/m^2, 1/m and 1; None unless the "
            "scan is simulated.")
        .def("points", &points_of,
             "(P, 2) The end points of the beams that hit something, in the robot's frame, in metres.")
        .def(py::pickle(&state_of_scan, &scan_of_state));
}

}  // namespace ddtool::python

#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "ddtool/robot/sensor_stream.hpp"
#include "py.hpp"

namespace ddtool::python {

/// A scan as Python sees it: a frame of a stream, and what a simulator knows of it.
struct HeldScan {
    SensorFrame frame;
    std::optional<Eigen::Matrix3d> fisher_information = std::nullopt;  ///< about the true pose, in the robot's frame
};

/// Registers ddtool.Scan.
void add_scans(py::module_& module);

}  // namespace ddtool::python

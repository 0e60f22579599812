#pragma once

#include "ddtool/robot/trajectory.hpp"
#include "py.hpp"

namespace ddtool::python {

/// A trajectory as Python sees it. It is never changed, so that views of it stay what they are.
struct HeldTrajectory {
    Trajectory poses;
};

/// A trajectory, or the path of a TUM file with one. Throws TypeError for anything else.
Trajectory trajectory_from(const py::object& value);

/// Registers ddtool.Trajectory and ddtool.score() with its types.
void add_trajectories(py::module_& module);

}  // namespace ddtool::python

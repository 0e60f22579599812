#pragma once

#include <filesystem>

#include "geometry/trajectory.hpp"

namespace ddtool {

/// TUM RGB-D trajectory files (Sturm et al. 2012): "stamp_s x y z qx qy qz qw" a line, '#' begins a comment.
/// Of a 3-D pose, x, y and the yaw are kept. Throws Error naming the file, the line and what was expected.
Trajectory read_tum(const std::filesystem::path& path);
void write_tum(const std::filesystem::path& path, const Trajectory& trajectory);

}  // namespace ddtool

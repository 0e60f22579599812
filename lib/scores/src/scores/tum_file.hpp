#pragma once

#include <filesystem>

#include "ddtool/robot/trajectory.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {

/// TUM RGB-D trajectory files (Sturm et al. 2012): "stamp_s x y z qx qy qz qw" a line, '#' begins a comment.
/// Of a 3-D pose, x, y and the yaw are kept. Throws Error naming the file, the line and what was expected.
Trajectory read_tum(const std::filesystem::path& path);
void write_tum(const std::filesystem::path& path, const Trajectory& trajectory);

/// The same, pose by pose. Throws OutputError naming the file.
class TumStream {
public:
    explicit TumStream(const std::filesystem::path& path);
    void add(const StampedPose& pose);
    /// Completes the file; without it nothing is left behind.
    void close() { file_.close(); }

private:
    AtomicStream file_;
};

}  // namespace ddtool

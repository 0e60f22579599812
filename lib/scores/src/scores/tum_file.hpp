#pragma once

#include <filesystem>

#include "ddtool/robot/trajectory.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {

/// TUM RGB-D trajectory files (Sturm et al. 2012): each line is "stamp_s x y z qx qy qz qw", and '#' begins a comment.
/// Of a pose in space, x, y and the yaw are kept. read_tum() throws Error naming the file, the line and what was
/// expected; write_tum() throws OutputError naming the file.
Trajectory read_tum(const std::filesystem::path& path);
void write_tum(const std::filesystem::path& path, const Trajectory& trajectory);

/// Writes a TUM file pose by pose. Throws OutputError naming the file.
class TumStream {
public:
    explicit TumStream(const std::filesystem::path& path);
    void add(const StampedPose& pose);
    /// Completes the file. Without close() no file is left behind.
    void close() { file_.close(); }

private:
    AtomicStream file_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// Tells apart the paths of several publishers whose poses are interleaved on one topic. A pose belongs to the path of
/// its own connection (where the log has connections) that it continues: that comes nearest to it at constant speed,
/// within what the robot's acceleration (3 m/s^2, 3 rad/s^2) and 2 cm or 0.02 rad of noise allow. Otherwise it begins
/// another path.
///
/// The poses are interleaved if two paths have at least twenty poses each, the topic changes between them at least
/// twenty times, and these changes are five times larger than the steps along the paths are uncertain. A source that
/// starts again changes once.
class InterleavedPaths {
public:
    static constexpr std::size_t most_paths = 4;

    /// The number of the path that the next pose of the log belongs to, from 0 on.
    std::size_t add(const StampedPose& pose, std::uint16_t connection);
    [[nodiscard]] bool are_interleaved() const;
    /// The number of poses of each path.
    [[nodiscard]] std::vector<std::size_t> counts() const;

private:
    struct Path {
        std::uint16_t connection = 0;
        StampedPose last{};
        Pose2 speed{};  ///< per second, in the frame of the last pose
        std::size_t count = 0;
        double error_sum = 0.0;  ///< of the predictions that its poses continued
    };

    [[nodiscard]] static double error(const Path& path, const StampedPose& pose);
    static void extend(Path& path, const StampedPose& pose);

    std::vector<Path> paths_;
    std::optional<std::size_t> last_;  ///< the path of the last pose
    std::size_t changes_ = 0;          ///< between paths that both go on
    double change_sum_ = 0.0;
};

}  // namespace ddtool

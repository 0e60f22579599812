#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// Tells apart the paths of several publishers whose poses are interleaved on one topic. A pose belongs to the path
/// that it continues, of those of its own connection (where the log has connections): that comes nearest to it at
/// constant speed, within what 2 cm or 0.02 rad of noise and a change of speed by 1 m/s and 1 rad/s allow. Otherwise it
/// begins another path. One that begins beside a path has branched off from it: until then the publishers agreed.
///
/// The poses are interleaved if there is a path that has twenty poses or more, at regular times, that the topic leaves
/// or enters at least twenty times, and whose distance from the poses before and after is then five times larger than
/// the errors of its own predictions. Of a source that is merely noisy, those poses that fit each other do not come at
/// regular times. A source that starts again changes once.
class InterleavedPaths {
public:
    static constexpr std::size_t most_paths = 16;
    static constexpr std::size_t least_poses = 20;

    /// The number of the path that the next pose of the log belongs to, from 0 on; most_paths: to none, because there
    /// are too many.
    std::size_t add(const StampedPose& pose, std::uint16_t connection);
    [[nodiscard]] bool are_interleaved() const;
    /// The number of paths so far.
    [[nodiscard]] std::size_t size() const { return paths_.size(); }
    /// The number of poses of a path.
    [[nodiscard]] std::size_t poses(std::size_t path) const { return paths_.at(path).count; }
    /// The paths from which the path branched off, the earliest first, and the path itself.
    [[nodiscard]] std::vector<std::size_t> lineage(std::size_t path) const;

private:
    struct State {
        StampedPose last{};
        Pose2 speed{};  ///< per second, in the frame of the last pose
    };
    struct Path {
        std::uint16_t connection = 0;
        State now{};
        State before{};  ///< without the last pose, which may have been one of another path that came near
        std::size_t count = 0;
        std::optional<std::size_t> parent = std::nullopt;
        double error_sum = 0.0;   ///< of the predictions that its poses continued
        double interval_s = 0.0;  ///< a running mean
        std::size_t regular = 0;  ///< intervals that differ from the mean by less than a half
        std::size_t changes = 0;  ///< to and from other paths
        double change_sum = 0.0;  ///< how far apart the poses before and after the changes are
    };

    [[nodiscard]] static double error(const State& state, const StampedPose& pose);
    static void extend(Path& path, const StampedPose& pose);
    [[nodiscard]] std::size_t begin(const Path& path);

    std::vector<Path> paths_;
    std::optional<std::size_t> last_;  ///< the path of the last pose
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"

namespace ddtool::check {

/// What one scan saw, for comparisons with other scans: its echoes by direction, at most `most_beams` of them. The
/// directions rise counter-clockwise, whichever way the lidar turns.
class Sight {
public:
    static constexpr std::size_t most_beams = 400;

    explicit Sight(const SensorFrame& frame);

    [[nodiscard]] const Pose2& robot_from_laser() const { return robot_from_laser_; }
    [[nodiscard]] std::size_t beams() const { return ranges_m_.size(); }
    /// In metres; no_return and invalid as LaserScan has them.
    [[nodiscard]] float range_m(std::size_t beam) const { return ranges_m_[beam]; }
    /// The end point in the laser's frame.
    [[nodiscard]] Point2 end(std::size_t beam) const;
    [[nodiscard]] double angle_rad(std::size_t beam) const {
        return angle_min_rad_ + static_cast<double>(beam) * increment_rad_;
    }
    [[nodiscard]] double increment_rad() const { return increment_rad_; }

    /// What this scan says of a surface point that another scan saw.
    enum class Word {
        same,     ///< this scan sees a surface there, too
        through,  ///< this scan saw a surface behind it, and free space all around the point
        nothing   ///< the point is hidden from this scan, out of its sight, or at the edge of something
    };
    /// \param point in this scan's laser frame, in metres
    /// \param tolerance_m a surface nearer than this to the point is the same
    [[nodiscard]] Word word_on(Point2 point, double tolerance_m) const;

private:
    [[nodiscard]] bool surface_near(Point2 point, std::size_t beam, double tolerance_m) const;

    Pose2 robot_from_laser_;
    double angle_min_rad_ = 0.0;
    double increment_rad_ = 0.0;
    bool full_turn_ = false;
    std::vector<float> ranges_m_;
};

/// How the surface points of one scan agree with another scan: so many points that it sees, too, and that it saw
/// through.
struct Agreement {
    std::size_t same = 0;
    std::size_t through = 0;

    [[nodiscard]] std::size_t points() const { return same + through; }
    /// The share of the points that both could see which the other saw through; 0 where there are none.
    [[nodiscard]] double contradicted() const;
};

/// Compares the surface points of `of` with what `by` saw, and the other way round.
/// \param by_from_of the pose of the robot at the scan `of` in the robot's frame at the scan `by`
Agreement agreement(const Sight& by, const Sight& of, const Pose2& by_from_of);

}  // namespace ddtool::check

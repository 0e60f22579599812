#pragma once

#include <complex>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"
#include "ddtool/robot/trajectory.hpp"

namespace ddtool {

/// Steps of about 10 cm that a lidar went in the first part of a log, by its scans alone. Memory and time do not grow
/// with the log: after most_steps steps, or most_compared comparisons, nothing is added. Scans between which the lidar
/// hardly moves, or which do not tell how it moves, are not all compared.
class ScanWay {
public:
    static constexpr std::size_t most_steps = 200;
    static constexpr std::size_t most_compared = 5000;

    struct Step {
        std::int64_t from_ns = 0;
        std::int64_t to_ns = 0;
        std::complex<double> moved_m;  ///< in the axes of the lidar at the first stamp
    };

    /// \param scan ranges as logged
    void add(const LaserScan& scan);
    [[nodiscard]] const std::vector<Step>& steps() const { return steps_; }
    [[nodiscard]] bool is_full() const { return steps_.size() >= most_steps || compared_ >= most_compared; }

private:
    void start(const LaserScan& scan);

    std::optional<LaserScan> from_;
    std::vector<Step> steps_;
    std::size_t compared_ = 0;
    std::size_t since_from_ = 0;   ///< scans
    std::size_t passed_over_ = 0;  ///< scans that are still to come
    std::size_t in_vain_ = 0;      ///< comparisons in a row
};

/// The poses of a moving frame along the log, in bounded memory.
class WayTrack {
public:
    static constexpr std::size_t most_poses = 20'000;

    void add(const StampedPose& odom_from_robot);
    /// The motion between two moments in the axes at the first of them; nullopt outside the poses.
    [[nodiscard]] std::optional<Pose2> moved(std::int64_t from_ns, std::int64_t to_ns) const;
    /// The median speed of the steps in which the frame moved; 0 where it never did.
    [[nodiscard]] double usual_m_per_s() const;

private:
    [[nodiscard]] std::optional<Pose2> pose_at(std::int64_t stamp_ns) const;

    std::vector<StampedPose> poses_;  ///< with rising stamps
};

/// How far the odometry moves for each metre that the scans do: 1, or thousands where it is in millimetres. The
/// lidar's direction on the robot does not matter. Found by least squares over the steps without outliers. Nullopt if
/// the scans do not tell it: too few steps, motions that have nothing to do with each other, or not the same in both
/// halves of the steps.
/// \param ahead_s added to the scans' stamps first, for clocks that are far apart
std::optional<double> way_scale(const ScanWay& scans, const WayTrack& odometry, double ahead_s);

/// Why odometry is not believed by its lengths; empty if it can be: "it moves 1000 times as far as the scans show (as
/// if in millimetres)", or, where the scans tell nothing, that it is faster than any robot.
std::string length_fault(const ScanWay& scans, const WayTrack& odometry, double ahead_s);

}  // namespace ddtool

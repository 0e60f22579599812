#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "ddtool/robot/sensor_stream.hpp"
#include "logs/stream/gyro_track.hpp"

namespace ddtool {

/// What the scans say of a gyro.
struct GyroVerdict {
    bool is_better = false;  ///< than the odometry's own turns, distinctly
    bool fits = false;       ///< the turns agree with the scans' to a fifth, at least
    double scale = 1.0;      ///< radians of turn for each unit of the gyro: 1, pi/180, or one of these with a minus
    double bias_rad_per_s = 0.0;  ///< what the gyro reads, after scaling, while the robot does not turn
    double error_rad = 0.0;       ///< of the turns, the median over the pairs
    double odometry_error_rad = 0.0;
    std::size_t pairs = 0;
};

/// Compares the turns of a gyro, and those of the odometry, with the turns between scans that are laid on each other
/// (robot/scan_alignment.hpp), over a second or 0.2 rad each. For one thread at a time.
class GyroTrial {
public:
    static constexpr std::size_t most_pairs = 300;
    static constexpr std::size_t least_pairs = 12;
    static constexpr std::size_t deciding_pairs = 30;
    static constexpr double least_turn_rad = 1.0;  ///< in total
    /// The odometry's own turns are kept unless those of the gyro err less by this share, which would matter, and by
    /// this many standard errors. If the odometry has its turns from the same gyro, they do not differ.
    static constexpr double least_gain = 0.05;
    static constexpr double least_deviations = 3.0;

    /// Returns whether there is now one more pair.
    /// \param frame with the odometry's own pose
    bool add(const SensorFrame& frame, const GyroTrack& gyro);
    /// Whether enough pairs show that the gyro is better.
    [[nodiscard]] bool is_decided() const;
    [[nodiscard]] bool is_complete() const { return pairs_.size() >= most_pairs; }
    /// Of the pairs so far; nullopt if they are too few, or if the robot has hardly turned.
    [[nodiscard]] std::optional<GyroVerdict> verdict() const;

private:
    struct Pair {
        double scans_rad = 0.0;
        double odometry_rad = 0.0;
        double gyro_rad = 0.0;  ///< not scaled
        double duration_s = 0.0;
    };
    struct Scan {
        std::int64_t stamp_ns = 0;
        Pose2 odom_from_robot;
        std::vector<Point2> points_m;
    };
    /// The errors of turns after the bias that suits them best is taken off. Some scans lie on each other wrongly, so
    /// that errors of more than three times the median say nothing of the bias, and count no more than that.
    struct Fit {
        double bias_rad_per_s = 0.0;
        std::vector<double> errors_rad;  ///< without sign
        double median_rad = 0.0;
        double share = 0.0;  ///< of the turns; large turns count most, since small ones do not tell the scale
    };

    /// \param has_bias false: the turns are taken as they are, because nothing takes a bias off the wheels'
    [[nodiscard]] Fit fit(const std::vector<double>& turns_rad, bool has_bias) const;
    [[nodiscard]] std::vector<double> gyro_turns_rad(double scale) const;

    std::optional<Scan> before_;
    std::vector<Pair> pairs_;
};

}  // namespace ddtool

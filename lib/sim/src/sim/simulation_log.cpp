#include "sim/simulation_log.hpp"

#include <string>

#include "logs/messages/ros_conversions.hpp"
#include "logs/stream/ros2_writer.hpp"

namespace ddtool::sim {
namespace {

constexpr const char* map_frame = "map";
constexpr const char* odom_frame = "odom";
constexpr const char* robot_frame = "base_link";
constexpr const char* laser_frame = "laser";
constexpr double gravity_m_per_s2 = 9.81;

RosFloat64MultiArray matrix_message(const Eigen::Matrix3d& matrix) {
    RosFloat64MultiArray message;
    message.dimensions = {{"row", 3, 9}, {"column", 3, 3}};
    for (Eigen::Index row = 0; row < 3; ++row) {
        for (Eigen::Index column = 0; column < 3; ++column) {
            message.data.push_back(matrix(row, column));
        }
    }
    return message;
}

/// Behind the names of the topic and the frame of a lidar: "", "_2", "_3".
std::string suffix_of(std::size_t lidar) { return lidar == 0 ? "" : "_" + std::to_string(lidar + 1); }

class SimulationLog {
public:
    SimulationLog(const Simulation& simulation, const std::filesystem::path& file)
        : odometry_(simulation.odometry()), turn_rates_(simulation.turn_rates()), writer_(file) {
        const std::int64_t start_ns = simulation.settings().start_ns;
        for (std::size_t lidar = 0; lidar < simulation.lidar_count(); ++lidar) {
            writer_.write("/tf_static", start_ns,
                          transform_message(start_ns, robot_frame, laser_frame + suffix_of(lidar),
                                            simulation.robot_from_laser(lidar)));
        }
    }

    void write(const SimulatedFrame& simulated) {
        const SensorFrame& frame = simulated.frame;
        const std::int64_t stamp_ns = frame.scan.stamp_ns;
        write_odometry_until(stamp_ns);
        const std::string suffix = suffix_of(frame.lidar);
        writer_.write("/scan" + suffix, stamp_ns, scan_message(frame.scan, laser_frame + suffix));
        if (frame.lidar > 0) {
            return;  // the truth is beside the scans of the first lidar
        }
        writer_.write("/ground_truth", stamp_ns,
                      odometry_message(stamp_ns, map_frame, robot_frame, *frame.world_from_robot));
        writer_.write("/fisher_information", stamp_ns, matrix_message(simulated.fisher_information));
    }

    void close() {
        write_odometry_until(odometry_.back().stamp_ns);
        writer_.close();
    }

private:
    void write_odometry_until(std::int64_t stamp_ns) {
        for (; next_rate_ < turn_rates_.size() && turn_rates_[next_rate_].stamp_ns <= stamp_ns; ++next_rate_) {
            const StampedTurnRate& rate = turn_rates_[next_rate_];
            RosImu message;
            message.header = {{rate.stamp_ns}, robot_frame};
            message.orientation_covariance.front() = -1.0;  // it is not measured
            message.angular_velocity.z = rate.rad_per_s;
            message.linear_acceleration.z = gravity_m_per_s2;
            writer_.write("/imu", rate.stamp_ns, message);
        }
        for (; next_ < odometry_.size() && odometry_[next_].stamp_ns <= stamp_ns; ++next_) {
            const StampedPose& stamped = odometry_[next_];
            writer_.write("/odom", stamped.stamp_ns, odometry_at(next_));
            writer_.write("/tf", stamped.stamp_ns,
                          transform_message(stamped.stamp_ns, odom_frame, robot_frame, stamped.pose));
        }
    }

    /// The velocity in the message is the mean velocity since the previous message.
    [[nodiscard]] RosOdometry odometry_at(std::size_t index) const {
        const StampedPose& now = odometry_[index];
        RosOdometry message = odometry_message(now.stamp_ns, odom_frame, robot_frame, now.pose);
        if (index > 0) {
            const StampedPose& before = odometry_[index - 1];
            const Pose2 motion = between(before.pose, now.pose);
            const double duration_s = 1e-9 * static_cast<double>(now.stamp_ns - before.stamp_ns);
            message.linear_velocity.x = motion.x_m / duration_s;
            message.angular_velocity.z = motion.theta_rad / duration_s;
        }
        return message;
    }

    const Trajectory& odometry_;
    std::vector<StampedTurnRate> turn_rates_;
    std::size_t next_rate_ = 0;
    Ros2Writer writer_;
    std::size_t next_ = 0;
};

}  // namespace

void write_simulation_log(const Simulation& simulation, const std::filesystem::path& file,
                          const std::function<void(std::size_t)>& on_scan) {
    SimulationLog log(simulation, file);
    for (std::size_t index = 0; index < simulation.frame_count(); ++index) {
        for (std::size_t lidar = 0; lidar < simulation.lidar_count(); ++lidar) {
            if (index < simulation.frame_count(lidar)) {
                log.write(simulation.frame(index, lidar));
            }
        }
        on_scan(index + 1);
    }
    log.close();
}

}  // namespace ddtool::sim

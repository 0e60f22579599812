#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "ddtool/robot/laser_scan.hpp"

namespace ddtool {

/// Positions further away than this are taken for damaged numbers, whose sums and squares would soon no longer be
/// finite.
inline constexpr double farthest_m = 1e9;

/// A laser scan as it is in a log, for all message types.
struct ScanReading {
    std::string frame_id;
    Eigen::Isometry3d frame_from_scan = Eigen::Isometry3d::Identity();  ///< the scan's own origin, if it has one
    LaserScan scan;                                                     ///< ranges as logged, not yet normalised
    bool has_stamp = true;  ///< false: the message's stamp is 0; the time of recording stands for it
};

/// Which echo of a beam counts if it has several.
enum class Echo {
    /// The nearest: the space before it is free for certain, and a pane of glass is a wall.
    first,
    /// The one with the largest intensity, which looks through rain, dust and glass.
    strongest,
};

/// A point cloud as it is in a log, for all message types.
struct CloudReading {
    std::int64_t stamp_ns = 0;
    std::string frame_id;
    Eigen::Isometry3d frame_from_cloud = Eigen::Isometry3d::Identity();  ///< the cloud's own origin, if it has one
    std::vector<Eigen::Vector3f> points_m = {};                          ///< in the cloud's frame; all are finite
    std::string fault = {};  ///< why the points could not be read; empty: they could
    bool has_stamp = true;   ///< false: the message's stamp is 0; the time of recording stands for it
};

/// A pose or transform as it is in a log, for all message types.
struct PoseReading {
    std::int64_t stamp_ns = 0;
    std::string frame_id;
    std::string child_frame_id;  ///< empty where the message type has none
    Eigen::Isometry3d frame_from_child = Eigen::Isometry3d::Identity();
    bool has_rotation = true;  ///< false: the message's quaternion is 0,0,0,0 or no number; the identity stands for it
    bool has_stamp = true;     ///< false: the message's stamp is 0; the time of recording stands for it
};

/// What an inertial sensor measures.
struct ImuReading {
    std::int64_t stamp_ns = 0;
    std::string frame_id;
    Eigen::Vector3d angular_velocity_rad_per_s = Eigen::Vector3d::Zero();  ///< in its frame
    Eigen::Vector3d acceleration_m_per_s2 = Eigen::Vector3d::Zero();       ///< in its frame; upwards at rest
};

/// A velocity as it is in a log.
struct VelocityReading {
    std::int64_t stamp_ns = 0;
    std::string frame_id;  ///< in whose axes the velocity is given: the robot's, or those of a fixed frame
    double x_m_s = 0.0;
    double y_m_s = 0.0;
    double turn_rad_s = 0.0;  ///< counter-clockwise
    bool has_stamp = true;    ///< false: the message's stamp is 0; the time of recording stands for it
};

}  // namespace ddtool

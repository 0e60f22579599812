#pragma once

#include <Eigen/Geometry>
#include <cstddef>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/robot/laser_scan.hpp"
#include "logs/messages/readings.hpp"

namespace ddtool {

/// The heights in which the points of a lidar count if no others are given, above the robot's origin, which is taken to
/// be on the floor. The band is 0.6 m high, so that a lidar whose nearest rings are one degree above and below the
/// horizontal sees walls in it up to 17 m away. It is around the lidar, but not below 0.1 m, where the floor is seen
/// when the robot pitches. Clouds that are already in the robot's frame get the band from 0.1 to 0.7 m.
HeightBand band_around_lidar(double lidar_height_m);
/// The same where it is not known how the lidar is mounted: around the lidar itself.
inline constexpr HeightBand band_around_unknown{-0.3, 0.3};

/// The points of a cloud within a band of heights as a scan of a full turn: for each beam the nearest of the points
/// in its direction, as sensor_msgs' pointcloud_to_laserscan does. The scan's frame has its origin at the lidar and its
/// axes parallel to those of the robot. Heights are those of the robot's frame, so that roll and pitch of the mounting
/// count. range_min_m and range_max_m are 0.
///
/// A beam without a point in the band is invalid, not without return. Whether the rings above or below it hit
/// something, or nothing, tells little of the space at the height of the band, which may be higher than the distance
/// between two rings.
/// \param beams of the full turn; 0: the most of 2880, 1440, 720, 360 and 180 that the cloud fills, so that surfaces
/// are not broken up by empty beams between the columns of the cloud
LaserScan cloud_scan(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_cloud, const HeightBand& band,
                     std::size_t beams);

/// The least and the largest height of the points of a cloud, which has at least one.
HeightBand heights_of(const CloudReading& cloud, const Eigen::Isometry3d& robot_from_lidar);

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>

#include "sim/simulation.hpp"

namespace ddtool::sim {

/// Writes the log that a robot would have recorded, an MCAP file of ROS 2 messages in the order of their stamps, and
/// beside it the truth:
///   /tf_static           tf2_msgs/TFMessage     base_link -> laser, once
///   /odom, /tf           nav_msgs/Odometry, tf2_msgs/TFMessage: odom -> base_link, at the odometry's rate
///   /imu                 sensor_msgs/Imu        in base_link, if the simulation has an inertial sensor
///   /scan                sensor_msgs/LaserScan  in laser; /scan_2 in laser_2 and so on of further lidars
///   /ground_truth        nav_msgs/Odometry      map -> base_link, at the scans' stamps
///   /fisher_information  std_msgs/Float64MultiArray, 3 x 3 row by row, at the scans' stamps; see
///   fisher_information.hpp
/// The same simulation gives the same bytes. Calls on_scan with the number of scans of the first lidar written, after
/// each.
void write_simulation_log(const Simulation& simulation, const std::filesystem::path& file,
                          const std::function<void(std::size_t)>& on_scan);

}  // namespace ddtool::sim

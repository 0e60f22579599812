#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/filter/occupancy_grid.hpp"
#include "ddtool/robot/sensor_stream.hpp"
#include "sim/simulation.hpp"

namespace ddtool::localization_bench {

/// A world with the lidar that is driven through it.
struct Place {
    std::string name;
    sim::World world;
    double range_m = 30.0;
};

/// A place by its name: "ring", or a world of ddtool simulate, with the range of the lidar behind an @ ("r1@8").
Place place_of(const std::string& name);

/// A map of a drive, made by the default method, or drawn at the true poses.
struct MadeMap {
    struct Pose {
        Pose2 world_from_robot;  ///< the truth
        Pose2 map_from_robot;    ///< where the map has its scan
    };

    /// Where a pose of the world is in the map, which may be bent: beside the nearest pose of the mapping drive.
    [[nodiscard]] Pose2 in_map(const Pose2& world_from_robot) const;

    std::shared_ptr<const OccupancyGrid> grid;
    std::vector<Pose> path;         ///< of the mapping drive
    Pose2 map_from_world;           ///< by the path of that drive and its truth
    double ate_m = 0.0;             ///< of that drive, aligned
    double ate_from_start_m = 0.0;  ///< of that drive from its first pose on, as a localisation has it
};

sim::Simulation drive_of(const Place& place, std::uint64_t seed);

/// All frames of a drive.
std::vector<SensorFrame> frames_of(const sim::Simulation& drive);

MadeMap map_of(const std::vector<SensorFrame>& frames);

/// The map that the scans give at their true poses: what is left is the error of the localisation alone.
MadeMap true_map_of(const std::vector<SensorFrame>& frames);

/// Writes a map and drives in it as text, to measure other programs on them. FOLDER/NAME.map: cell size in m, columns,
/// rows, x and y of the lower left corner, then the rows from below: # occupied, . free, ? unknown.
/// FOLDER/NAME-SEED.drive, a line for each scan: the odometry's x, y, theta, the true ones in the map, and how many
/// points follow, x and y of each in the robot's frame.
void write_map(const std::filesystem::path& folder, const Place& place, const MadeMap& map);
void write_drive(const std::filesystem::path& folder, const Place& place, const MadeMap& map, std::uint64_t seed,
                 const std::vector<SensorFrame>& frames);

}  // namespace ddtool::localization_bench

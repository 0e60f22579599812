#include "dataset/drive_window.hpp"

#include <cmath>
#include <limits>

namespace ddtool::dataset {
namespace {

/// The number of updates that the filter makes on the drive. The filter decides by the odometry when to make an update;
/// here its rule is applied to the true trajectory.
std::uint64_t updates_on(const Trajectory& way, double distance_m, double turn_rad) {
    std::uint64_t updates = 0;
    Pose2 last = way.front().pose;
    for (const StampedPose& next : way) {
        const Pose2 motion = between(last, next.pose);
        if (std::hypot(motion.x_m, motion.y_m) >= distance_m || std::abs(motion.theta_rad) >= turn_rad) {
            ++updates;
            last = next.pose;
        }
    }
    return updates;
}

}  // namespace

DriveWindow window_of(const sim::Simulation& simulation, const RunEntry& run, std::uint64_t most_particle_updates,
                      RandomStream random) {
    const std::uint64_t whole = updates_on(simulation.truth(), run.update_distance_m, run.update_turn_rad);
    const std::uint64_t most = std::max<std::uint64_t>(2, most_particle_updates / run.particles);
    if (whole <= most) {
        return {0, std::numeric_limits<std::uint64_t>::max(), whole};
    }
    const double share = static_cast<double>(most) / static_cast<double>(whole);
    const double begin = random.uniform(0.0, 1.0 - share);
    return {static_cast<std::size_t>(begin * static_cast<double>(simulation.frame_count())), most, most};
}

}  // namespace ddtool::dataset

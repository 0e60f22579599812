#include "swarm/modes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ddtool {

std::vector<Mode> modes_of(std::span<const SnapshotParticle> particles) {
    std::vector<std::size_t> order(particles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order,
                             [&](std::size_t a, std::size_t b) { return particles[a].weight > particles[b].weight; });
    std::vector<Mode> modes;
    for (const std::size_t index : order) {
        const Pose2& pose = particles[index].pose;
        const auto found = std::ranges::find_if(modes, [&](const Mode& mode) {
            const Pose2& centre = particles[mode.particles.front()].pose;
            return distance_m(centre, pose) < mode_m &&
                   std::abs(wrap_angle(centre.theta_rad - pose.theta_rad)) < mode_rad;
        });
        Mode& mode = found == modes.end() ? modes.emplace_back() : *found;
        mode.particles.push_back(index);
        mode.weight += particles[index].weight;
    }
    std::ranges::stable_sort(modes, [](const Mode& a, const Mode& b) { return a.weight > b.weight; });
    return modes;
}

}  // namespace ddtool

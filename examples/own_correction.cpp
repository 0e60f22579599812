// A correction of one's own: where the swarm is degenerate, each particle's match is moved half the way to the pose
// that the odometry predicts. The filter calls it for all particles, from many threads at once, so the object holds
// settings only.
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>

#include "ddtool/filter/rbpf.hpp"

class HalfWayToTheOdometry : public ddtool::PoseCorrection {
public:
    ddtool::ScanMatch correct(const ddtool::MatchContext& context, const ddtool::ScanMatch& found) const override {
        if (context.degeneracy.degree < 0.5) {
            return found;
        }
        // Score, information and likelihood depend on the pose, so they are computed anew.
        const ddtool::Pose2 half_way = ddtool::interpolate(found.pose, context.odometry, 0.5);
        return context.matcher.evaluate(context.grid, context.points, half_way);
    }
};

int main() {
    ddtool::FilterStrategies strategies;
    strategies.detector = [](const ddtool::ParticleSnapshot& /*swarm*/) { return ddtool::Degeneracy{1.0}; };
    strategies.corrections = {std::make_shared<HalfWayToTheOdometry>()};
    ddtool::ThreadPool threads;
    ddtool::Rbpf filter({}, threads, strategies);
    double corrected_m = 0.0;
    // a corridor of two walls; the odometry reports 0.11 m per step, while the scans of a corridor show no motion
    for (int i = 0; i < 20; ++i) {
        ddtool::SensorFrame frame;
        frame.odom_from_robot = {0.11 * i, 0.0, 0.0};
        frame.scan = {.stamp_ns = i * 100'000'000LL,
                      .angle_min_rad = -std::numbers::pi,
                      .angle_increment_rad = std::numbers::pi / 180.0,
                      .range_max_m = 12.0,
                      .ranges_m = {}};
        for (std::size_t beam = 0; beam < 360; ++beam) {
            frame.scan.ranges_m.push_back(static_cast<float>(1.0 / std::abs(std::sin(frame.scan.angle_rad(beam)))));
        }
        ddtool::normalise_ranges(frame.scan);
        if (const auto update = filter.update(frame)) {
            corrected_m += ddtool::distance_m(update->matched.particles[0].pose, update->corrected.particles[0].pose);
        }
    }
    std::cout << "corrected by " << corrected_m << " m in all\n";
}

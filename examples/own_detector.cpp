// A detector of one's own with its own name. Its degree is the share of the particles' predicted spread along the
// direction of travel that is left after matching. A second detector, which always answers 0.5, then judges the same
// log.
#include <algorithm>
#include <cmath>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

#include "ddtool/methods/driven_scans.hpp"
#include "ddtool/methods/method.hpp"

/// The standard deviation of the motions along the robot's x axis, in metres.
static double spread_along_m(const ddtool::ParticleSnapshot& swarm, ddtool::Pose2 ddtool::SnapshotParticle::*motion) {
    double sum = 0.0;
    double squares = 0.0;
    for (const ddtool::SnapshotParticle& particle : swarm.particles) {
        const double x_m = (particle.*motion).x_m;
        sum += x_m;
        squares += x_m * x_m;
    }
    const auto count = static_cast<double>(swarm.particles.size());
    return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
}

static ddtool::Degeneracy along_the_way(const ddtool::ParticleSnapshot& swarm) {
    const double predicted_m = spread_along_m(swarm, &ddtool::SnapshotParticle::predicted_motion);
    const double matched_m = spread_along_m(swarm, &ddtool::SnapshotParticle::matched_motion);
    return {predicted_m > 0.0 ? std::min(1.0, matched_m / predicted_m) : 0.0};
}

/// The mean degree over the updates of a log.
static double mean_degree(const std::string& log, const std::string& detector) {
    ddtool::DetectorTable detectors;
    detectors.add("along-the-way", along_the_way);
    detectors.add("half", [](const ddtool::ParticleSnapshot& /*swarm*/) { return ddtool::Degeneracy{0.5}; });
    ddtool::FilterSettings settings;
    settings.method.parts.detector = detector;
    settings.method.parts.gate = "none";  // asks the detector at every update, not only where matching is in doubt
    ddtool::ThreadPool threads;
    const auto filter = ddtool::make_filter(settings, detectors, threads);
    const auto report = [](const ddtool::LogProblem& problem) { std::cerr << problem.what << '\n'; };
    ddtool::DrivenScans scans(ddtool::open_log(log, {}, report), settings.rbpf);
    double sum = 0.0;
    int updates = 0;
    while (const auto frame = scans.next()) {
        if (const auto update = filter->update(*frame); update && update->matched.update > 0) {
            sum += update->degeneracy.degree;
            ++updates;
        }
    }
    return updates > 0 ? sum / updates : 0.0;
}

int main(int argc, char** argv) try {
    if (argc != 2) {
        throw std::runtime_error("expected: own_detector LOG");
    }
    std::cout << "along-the-way " << mean_degree(argv[1], "along-the-way") << ", half " << mean_degree(argv[1], "half")
              << '\n';
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

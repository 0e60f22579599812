#include "train/augmentation.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "train/draws.hpp"

namespace ddtool::train {
namespace {

/// A transformation about the origin: mirroring at the x axis (if `mirrored`), and then a rotation.
struct ChangeOfSide {
    double turn_rad = 0.0;
    bool mirrored = false;

    [[nodiscard]] Pose2 operator()(const Pose2& pose) const {
        const double sign = mirrored ? -1.0 : 1.0;
        return Pose2{0.0, 0.0, turn_rad} * Pose2{pose.x_m, sign * pose.y_m, sign * pose.theta_rad};
    }
};

/// The mean of the finite positions, or the origin if there are none.
Point2 middle_of(std::span<const SnapshotParticle> particles) {
    Point2 sum;
    double count = 0.0;
    for (const SnapshotParticle& particle : particles) {
        if (std::isfinite(particle.pose.x_m) && std::isfinite(particle.pose.y_m)) {
            sum = {sum.x_m + particle.pose.x_m, sum.y_m + particle.pose.y_m};
            count += 1.0;
        }
    }
    return count > 0.0 ? Point2{sum.x_m / count, sum.y_m / count} : Point2();
}

void change_side(std::span<SnapshotParticle> particles, const ChangeOfSide& change) {
    const Point2 middle = middle_of(particles);
    const Pose2 to_previous{0.0, 0.0, -change.turn_rad};
    for (SnapshotParticle& particle : particles) {
        const Pose2 moved =
            change({particle.pose.x_m - middle.x_m, particle.pose.y_m - middle.y_m, particle.pose.theta_rad});
        particle.pose = {middle.x_m + moved.x_m, middle.y_m + moved.y_m, moved.theta_rad};
        // The robot's previous frame is rotated, too, so the rotation within the motion does not change.
        for (Pose2* motion : {&particle.matched_motion, &particle.predicted_motion}) {
            *motion = change(*motion) * to_previous;
        }
    }
}

/// A number from least to most, drawn so that its logarithm is distributed uniformly: each number n has a probability
/// in proportion to log(1 + 1 / n).
std::size_t drawn_count(std::size_t least, std::size_t most, RandomStream& random) {
    const auto low = static_cast<double>(least);
    const double ratio = static_cast<double>(most + 1) / low;
    return std::min(static_cast<std::size_t>(low * std::pow(ratio, random.uniform())), most);
}

void thin(std::vector<SnapshotParticle>& particles, std::size_t least, RandomStream& random) {
    if (particles.size() <= least) {
        return;
    }
    const std::size_t count = drawn_count(least, particles.size(), random);
    shuffle_front(particles, count, random);
    particles.resize(count);
    double sum = 0.0;
    for (const SnapshotParticle& particle : particles) {
        sum += particle.weight;
    }
    for (SnapshotParticle& particle : particles) {
        particle.weight = sum > 0.0 ? particle.weight / sum : 1.0 / static_cast<double>(count);
    }
}

}  // namespace

void augment(std::vector<SnapshotParticle>& particles, const AugmentationSettings& settings, RandomStream& random) {
    ChangeOfSide change;
    if (settings.rotate) {
        change.turn_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
    }
    if (settings.flip) {
        change.mirrored = random.uniform() < 0.5;
    }
    if (change.mirrored || change.turn_rad != 0.0) {
        change_side(particles, change);
    }
    if (settings.resample_particles) {
        thin(particles, settings.least_particles, random);
    }
}

}  // namespace ddtool::train

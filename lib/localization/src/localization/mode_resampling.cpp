#include "localization/mode_resampling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "swarm/modes.hpp"

namespace ddtool::localization {
namespace {

/// A mode of less weight is dropped.
constexpr double least_weight = 1e-4;
constexpr std::size_t least_per_mode = 2;
/// Cells of KLD sampling, as AMCL has them.
constexpr double cell_m = 0.5;
constexpr double cell_rad = 0.1745;

/// The number of samples with which the Kullback-Leibler distance from the true distribution over `cells` cells stays
/// below `error` with a probability of .99 (Fox 2003, eq. 7, with the approximation of Wilson and Hilferty).
double kld_bound(std::size_t cells, double error) {
    if (cells < 2) {
        return 0.0;
    }
    constexpr double quantile = 2.326;
    const auto freedom = static_cast<double>(cells - 1);
    const double ninth = 2.0 / (9.0 * freedom);
    return freedom / (2.0 * error) * std::pow(1.0 - ninth + std::sqrt(ninth) * quantile, 3.0);
}

}  // namespace

std::size_t ModeResampling::wanted(std::span<const SnapshotParticle> particles) const {
    std::set<std::array<long, 3>> cells;
    for (const SnapshotParticle& particle : particles) {
        if (particle.weight >= least_weight / static_cast<double>(particles.size())) {
            cells.insert({std::lround(particle.pose.x_m / cell_m), std::lround(particle.pose.y_m / cell_m),
                          std::lround(particle.pose.theta_rad / cell_rad)});
        }
    }
    const double bound = std::ceil(kld_bound(cells.size(), settings_.kld_error));
    return std::clamp(static_cast<std::size_t>(bound), settings_.least_particles, settings_.most_particles);
}

bool ModeResampling::is_due(std::span<const SnapshotParticle> particles) const {
    return 2 * wanted(particles) < particles.size() || 2 * particles.size() < settings_.least_particles;
}

std::vector<Descendant> ModeResampling::resample(std::span<const SnapshotParticle> particles,
                                                 RandomStream& random) const {
    const auto all = static_cast<double>(wanted(particles));
    std::vector<Descendant> descendants;
    for (const Mode& mode : modes_of(particles)) {
        const bool is_full = descendants.size() + least_per_mode > settings_.most_particles;
        if (!descendants.empty() && (mode.weight < least_weight || is_full)) {
            break;
        }
        const auto count = std::max(least_per_mode, static_cast<std::size_t>(std::lround(all * mode.weight)));
        double sum = 0.0;
        double next = random.uniform() * mode.weight / static_cast<double>(count);
        std::size_t drawn = 0;
        for (const std::size_t parent : mode.particles) {
            sum += particles[parent].weight;
            for (; drawn < count && next < sum; ++drawn) {
                descendants.push_back({parent, particles[parent].pose, all * mode.weight / static_cast<double>(count)});
                next += mode.weight / static_cast<double>(count);
            }
        }
        for (; drawn < count; ++drawn) {  // rounding
            const std::size_t parent = mode.particles.front();
            descendants.push_back({parent, particles[parent].pose, all * mode.weight / static_cast<double>(count)});
        }
    }
    return descendants;
}

}  // namespace ddtool::localization

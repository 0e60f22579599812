#include "particles/spread.hpp"

#include <cmath>

namespace ddtool {

double spread_m(std::span<const SnapshotParticle> particles, Pose2 SnapshotParticle::*position) {
    // Welford's update: one pass, no cancellation.
    double count = 0.0;
    double mean_x = 0.0, mean_y = 0.0;
    double xx = 0.0, xy = 0.0, yy = 0.0;
    for (const SnapshotParticle& particle : particles) {
        const Pose2& at = particle.*position;
        if (!std::isfinite(at.x_m) || !std::isfinite(at.y_m)) {
            continue;
        }
        count += 1.0;
        const double dx = at.x_m - mean_x;
        const double dy = at.y_m - mean_y;
        mean_x += dx / count;
        mean_y += dy / count;
        xx += dx * (at.x_m - mean_x);
        xy += dx * (at.y_m - mean_y);
        yy += dy * (at.y_m - mean_y);
    }
    const double largest_eigenvalue = (xx + yy) / 2.0 + std::hypot((xx - yy) / 2.0, xy);
    return count < 2.0 ? 0.0 : std::sqrt(largest_eigenvalue / (count - 1.0));
}

}  // namespace ddtool

#include "dataset/record_labels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ddtool::dataset {
namespace {

Eigen::Matrix3d matrix_of(const std::array<double, 6>& information) {
    const auto& [xx, xy, xt, yy, yt, tt] = information;
    return (Eigen::Matrix3d() << xx, xy, xt, xy, yy, yt, xt, yt, tt).finished();
}

}  // namespace

void set_labels(SampleRecord& record, std::span<const SnapshotParticle> particles, const RbpfSettings& filter,
                const LabelSettings& rules) {
    record.dispersion = dispersions(particles);
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    PhysicalDegeneracy physical{unknown, unknown, unknown, unknown};
    const bool known = std::none_of(record.information.begin(), record.information.end(),
                                    [](double each) { return std::isnan(each); });
    if (known) {
        physical = physical_degeneracy(
            information_on_map(matrix_of(record.information), record.range_sd_m, filter.grid.cell_size_m),
            motion_sigmas(record.odometry_motion, filter.motion));
    }
    record.weak_sd_m = physical.weak_sd_m;
    record.weak_direction_rad = physical.weak_direction_rad;
    record.strong_sd_m = physical.strong_sd_m;
    record.odometry_sd_m = physical.odometry_sd_m;
    record.label = {dispersion_label(record.dispersion, rules),
                    fisher_label(physical.weak_sd_m, physical.odometry_sd_m, rules)};
}

}  // namespace ddtool::dataset

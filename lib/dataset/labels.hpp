#pragma once

#include <Eigen/Core>
#include <array>
#include <span>
#include <string>

#include "dataset/sample_record.hpp"
#include "particles/motion_model.hpp"

namespace ddtool::dataset {

/// The weights of which a snapshot's dispersion R = var(w) / |mean(w)| is taken, in the order of SampleRecord.
inline constexpr std::array<const char*, 4> dispersion_weight_names{"log_likelihood", "log_likelihood_increment",
                                                                    "match_score", "weight"};

struct LabelSettings {
    std::string dispersion_weight = "log_likelihood";  ///< of dispersion_weight_names
    double dispersion_threshold = 1.0;                 ///< degenerate above it (the paper's eq. label_explain)
    double fisher_ratio = 1.0;                         ///< degenerate above it: weak_sd_m / odometry_sd_m
};

/// R over each weight, in the order of dispersion_weight_names.
std::array<double, 4> dispersions(std::span<const SnapshotParticle> particles);

/// How well a scan holds the position, heading unknown (Cramer-Rao): sd along the direction least and best held.
/// Infinite where nothing holds it.
struct PhysicalDegeneracy {
    double weak_sd_m = 0.0;
    double weak_direction_rad = 0.0;  ///< in the robot's frame, in (-pi/2, pi/2]
    double strong_sd_m = 0.0;
    double odometry_sd_m = 0.0;  ///< of the motion model over the step, along the weak direction
};

/// information: of the scan about (x, y, theta) in the robot's frame; odometry: of the step that led to it.
PhysicalDegeneracy physical_degeneracy(const Eigen::Matrix3d& information, const MotionSigmas& odometry);

/// Information of a scan that is matched to a map of cells instead of the true surfaces: these are known to a uniform
/// cell's standard deviation, which adds to the beam's.
Eigen::Matrix3d information_on_map(const Eigen::Matrix3d& information, double range_sd_m, double cell_size_m);

/// R over the weight that the label takes it of. Throws UsageError for an unknown weight.
double labelled_dispersion(const std::array<double, 4>& dispersions, const LabelSettings& settings);
Label dispersion_label(const std::array<double, 4>& dispersions, const LabelSettings& settings);
/// Unknown for sd that are NaN.
Label fisher_label(double weak_sd_m, double odometry_sd_m, const LabelSettings& settings);

}  // namespace ddtool::dataset

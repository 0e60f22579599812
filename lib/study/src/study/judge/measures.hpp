#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "dataset/labels.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// A number computed from a swarm that may indicate degeneracy.
struct Measure {
    std::string name;
    std::string swarm;  ///< what it looks at: absolute, step or weights
    std::function<double(Particles)> value;
};

/// The measures that rules are made from: R over the weight that the label uses; the effective sample size as a share
/// of the particles; the spread along the major axis of the absolute swarm, of the step swarm, and of the step swarm
/// relative to the predicted spread; and the eigenvalue test of Switch-SLAM (Lee et al. 2024) as the paper compares
/// with it, the larger eigenvalue of the particles' weighted covariance in place of the inverse of the Hessian's
/// smaller one: of the positions of either swarm, and of the weights themselves, which is the literal reading of the
/// paper's eq. w_eigen.
std::vector<Measure> simple_measures(const dataset::LabelSettings& labels);

/// Logarithms of the spreads along both axes (no less than 0.1 mm) of the absolute, the matched and the predicted
/// positions, of the absolute and the matched positions with weights as well, and of the number of particles. Ratios,
/// such as of the matched spread to the predicted one, are differences of these.
Eigen::VectorXd covariance_features(Particles swarm);

}  // namespace ddtool::judge

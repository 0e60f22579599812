#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "dataset/labels.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::judge {

/// One number of a swarm that may tell degeneracy.
struct Measure {
    std::string name;
    std::string swarm;  ///< what it looks at: absolute, step or weights
    std::function<double(Particles)> value;
};

/// R over the weight that the label takes it of; the effective sample size as a share of the particles; the spread
/// along the major axis of the absolute swarm, of the step swarm, and of the latter in predicted spreads; and the
/// eigenvalue test of Switch-SLAM (Lee et al. 2024) as the paper compares with it, the larger eigenvalue of the
/// particles' weighted covariance in place of the inverse of the Hessian's smaller one: of the positions of either
/// swarm, and of the weights themselves, as the paper's eq. w_eigen has it word by word.
std::vector<Measure> simple_measures(const dataset::LabelSettings& labels);

/// Logarithms of the spreads along both axes (no less than 0.1 mm) of the absolute, the matched and the predicted
/// positions, of the first two weighted as well, and of the number of particles. Ratios, such as of the matched spread
/// to the predicted one, are differences of these.
Eigen::VectorXd covariance_features(Particles swarm);

}  // namespace ddtool::judge

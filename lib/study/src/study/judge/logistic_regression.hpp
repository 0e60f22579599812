#pragma once

#include <Eigen/Core>
#include <vector>

namespace ddtool::judge {

/// Logistic regression: P(positive) = 1 / (1 + exp(-(b + a z))) of standardised features z, with a ridge |a|^2 / 2
/// added to the negative log-likelihood, so that the coefficients are finite even if a plane separates the classes
/// perfectly.
class LogisticRegression {
public:
    /// features: one row for each sample, one column for each feature. Fits by Newton's method, which here is
    /// iteratively reweighted least squares (Bishop 2006, 4.3.3). Throws Error if one of the classes has no sample.
    LogisticRegression(const Eigen::MatrixXd& features, const std::vector<bool>& positive);

    [[nodiscard]] double probability(const Eigen::VectorXd& features) const;

private:
    Eigen::VectorXd mean_;
    Eigen::VectorXd scale_;         ///< standard deviations; 1 for a feature that does not vary
    Eigen::VectorXd coefficients_;  ///< the constant first
};

}  // namespace ddtool::judge

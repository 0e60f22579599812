#include "study/judge/logistic_regression.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"

namespace ddtool::judge {
namespace {

constexpr double ridge = 1.0;
constexpr int most_iterations = 100;
constexpr double least_step = 1e-10;

Eigen::VectorXd probabilities(const Eigen::MatrixXd& design, const Eigen::VectorXd& coefficients) {
    return (1.0 + (-(design * coefficients).array()).exp()).inverse();
}

/// The function to minimise: the negative log-likelihood plus the ridge penalty. The terms log(1 + exp(-+logit)) are
/// written so that they cannot overflow.
double penalised_loss(const Eigen::MatrixXd& design, const Eigen::VectorXd& targets,
                      const Eigen::VectorXd& coefficients) {
    const Eigen::ArrayXd margins = (design * coefficients).array() * (1.0 - 2.0 * targets.array());
    const Eigen::ArrayXd losses = margins.max(0.0) + (-margins.abs()).exp().log1p();
    return losses.sum() + 0.5 * ridge * coefficients.tail(coefficients.size() - 1).squaredNorm();
}

Eigen::VectorXd newton_step(const Eigen::MatrixXd& design, const Eigen::VectorXd& targets,
                            const Eigen::VectorXd& coefficients) {
    const Eigen::VectorXd predicted = probabilities(design, coefficients);
    Eigen::VectorXd penalty = Eigen::VectorXd::Constant(coefficients.size(), ridge);
    penalty[0] = 0.0;
    const Eigen::VectorXd gradient = design.transpose() * (predicted - targets) + penalty.cwiseProduct(coefficients);
    const Eigen::VectorXd weights = predicted.array() * (1.0 - predicted.array());
    Eigen::MatrixXd hessian = design.transpose() * weights.asDiagonal() * design;
    hessian.diagonal() += penalty;
    return -hessian.ldlt().solve(gradient);
}

Eigen::VectorXd fitted(const Eigen::MatrixXd& design, const Eigen::VectorXd& targets) {
    Eigen::VectorXd coefficients = Eigen::VectorXd::Zero(design.cols());
    double loss = penalised_loss(design, targets, coefficients);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        Eigen::VectorXd step = newton_step(design, targets, coefficients);
        double next = penalised_loss(design, targets, coefficients + step);
        // the step was too long, because the curvature changes along it
        while (next > loss && step.norm() > least_step) {
            step /= 2.0;
            next = penalised_loss(design, targets, coefficients + step);
        }
        if (!(next <= loss)) {
            break;
        }
        coefficients += step;
        loss = next;
        if (step.norm() <= least_step) {
            break;
        }
    }
    return coefficients;
}

}  // namespace

LogisticRegression::LogisticRegression(const Eigen::MatrixXd& features, const std::vector<bool>& positive)
    : mean_(features.colwise().mean().transpose()),
      scale_(((features.rowwise() - mean_.transpose()).colwise().squaredNorm() / static_cast<double>(features.rows()))
                 .cwiseSqrt()
                 .transpose()) {
    const auto positives = std::count(positive.begin(), positive.end(), true);
    if (positives == 0 || positives == static_cast<std::ptrdiff_t>(positive.size())) {
        throw Error("logistic regression: expected samples of both classes");
    }
    scale_ = (scale_.array() > 0.0).select(scale_, 1.0);
    Eigen::MatrixXd design(features.rows(), features.cols() + 1);
    design.col(0).setOnes();
    design.rightCols(features.cols()) =
        (features.rowwise() - mean_.transpose()).array().rowwise() / scale_.transpose().array();
    Eigen::VectorXd targets(features.rows());
    for (Eigen::Index row = 0; row < targets.size(); ++row) {
        targets[row] = positive[static_cast<std::size_t>(row)] ? 1.0 : 0.0;
    }
    coefficients_ = fitted(design, targets);
}

double LogisticRegression::probability(const Eigen::VectorXd& features) const {
    const Eigen::VectorXd standardised = (features - mean_).cwiseQuotient(scale_);
    return 1.0 / (1.0 + std::exp(-coefficients_[0] - coefficients_.tail(features.size()).dot(standardised)));
}

}  // namespace ddtool::judge

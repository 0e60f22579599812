#include "study/judge/logistic_regression.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"
#include "ddtool/base/random.hpp"

namespace ddtool::judge {
namespace {

struct Sampled {
    Eigen::MatrixXd features;
    std::vector<bool> positive;
};

double truth(const Eigen::VectorXd& features) {
    return 1.0 / (1.0 + std::exp(-(0.5 + 1.5 * features[0] - 2.0 * features[1])));
}

/// Classes that are drawn with known probabilities. The third feature has no influence on them.
Sampled drawn(Eigen::Index count) {
    RandomStream random({3});
    Sampled sampled{Eigen::MatrixXd(count, 3), {}};
    for (Eigen::Index row = 0; row < count; ++row) {
        sampled.features.row(row) << random.normal(), random.normal(), random.normal();
        sampled.positive.push_back(random.uniform() < truth(sampled.features.row(row).transpose()));
    }
    return sampled;
}

TEST(LogisticRegression, FindsTheProbabilitiesThatDrewTheClasses) {
    const Sampled sampled = drawn(20000);
    const LogisticRegression regression(sampled.features, sampled.positive);
    for (Eigen::Index row = 0; row < 100; ++row) {
        const Eigen::VectorXd features = sampled.features.row(row).transpose();
        EXPECT_NEAR(regression.probability(features), truth(features), 0.03);
    }
}

TEST(LogisticRegression, DoesNotMindUnitsAndOrigins) {
    const Sampled sampled = drawn(500);
    Eigen::MatrixXd changed = sampled.features;
    changed.col(0) = 1000.0 * changed.col(0).array() + 7.0;
    changed.col(1) *= -0.001;
    const LogisticRegression plain(sampled.features, sampled.positive);
    const LogisticRegression other(changed, sampled.positive);
    for (Eigen::Index row = 0; row < 50; ++row) {
        EXPECT_NEAR(plain.probability(sampled.features.row(row).transpose()),
                    other.probability(changed.row(row).transpose()), 1e-8);
    }
}

TEST(LogisticRegression, MeanProbabilityIsTheShareOfPositives) {
    const Sampled sampled = drawn(500);
    const LogisticRegression regression(sampled.features, sampled.positive);
    double sum = 0.0;
    for (Eigen::Index row = 0; row < 500; ++row) {
        sum += regression.probability(sampled.features.row(row).transpose());
    }
    EXPECT_NEAR(sum, static_cast<double>(std::count(sampled.positive.begin(), sampled.positive.end(), true)), 1e-6)
        << "the derivative by the constant, which has no ridge";
}

TEST(LogisticRegression, StaysFiniteWhereAPlanePartsTheClassesAndAFeatureIsConstant) {
    Eigen::MatrixXd features(4, 2);
    features << -2.0, 5.0, -1.0, 5.0, 1.0, 5.0, 2.0, 5.0;
    const LogisticRegression regression(features, {false, false, true, true});
    EXPECT_GT(regression.probability(Eigen::Vector2d(1.0, 5.0)), 0.5);
    EXPECT_LT(regression.probability(Eigen::Vector2d(2.0, 5.0)), 1.0);
    EXPECT_NEAR(regression.probability(Eigen::Vector2d(0.0, 5.0)), 0.5, 1e-9);
}

TEST(LogisticRegression, WantsBothClasses) {
    EXPECT_THROW(LogisticRegression(Eigen::MatrixXd::Ones(2, 1), {true, true}), Error);
}

}  // namespace
}  // namespace ddtool::judge

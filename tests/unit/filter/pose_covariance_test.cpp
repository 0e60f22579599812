#include "filter/pose_covariance.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>

namespace ddtool {
namespace {

TEST(PredictedCovariance, CarriesTheHeadingsErrorToTheSide) {
    Eigen::Matrix3d heading_only = Eigen::Matrix3d::Zero();
    heading_only(2, 2) = 0.01 * 0.01;
    const Eigen::Matrix3d result = predicted_covariance(heading_only, {5.0, 6.0, 0.0}, {10.0, 0.0, 0.0}, {});
    EXPECT_NEAR(result(1, 1), 0.1 * 0.1, 1e-5);
    EXPECT_NEAR(result(0, 0), 0.0, 1e-5);
    EXPECT_GT(result(1, 2), 0.0);
}

TEST(PredictedCovariance, LaysTheMotionsNoiseAlongTheHeading) {
    const Eigen::Matrix3d result =
        predicted_covariance(Eigen::Matrix3d::Zero(), {0.0, 0.0, 1.5707963267948966}, {}, {0.2, 0.1, 0.05});
    EXPECT_NEAR(result(0, 0), 0.01, 1e-6);
    EXPECT_NEAR(result(1, 1), 0.04, 1e-6);
    EXPECT_NEAR(result(2, 2), 0.0025, 1e-6);
}

TEST(PredictedCovariance, OfNoMotionAndNoNoiseIsRegular) {
    EXPECT_GT(predicted_covariance(Eigen::Matrix3d::Zero(), {}, {}, {}).determinant(), 0.0);
}

TEST(CorrectedCovariance, AddsInformation) {
    Eigen::Matrix3d covariance;
    covariance << 0.04, 0.01, 0.0, 0.01, 0.09, 0.002, 0.0, 0.002, 0.01;
    const Eigen::Matrix3d information = Eigen::Vector3d(100.0, 0.0, 50.0).asDiagonal();
    const Eigen::Matrix3d result = corrected_covariance(covariance, information);
    EXPECT_TRUE(result.inverse().isApprox(covariance.inverse() + information, 1e-9));
    EXPECT_TRUE(corrected_covariance(covariance, Eigen::Matrix3d::Zero()).isApprox(covariance, 1e-12));
}

}  // namespace
}  // namespace ddtool

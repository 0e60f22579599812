#include "ddtool/filter/odometry_trust.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>

namespace ddtool {
namespace {

ScanMatch by_odometry(const MatchContext& context) {
    ScanMatch match = context.matcher.evaluate(context.grid, context.points, context.odometry);
    match.information.setZero();  // the scan did not influence this pose
    return match;
}

}  // namespace

double lidar_trust(double degree) { return -std::exp(0.7 * degree) + std::exp(0.35) + 1.0; }

ScanMatch LidarScoreTrust::correct(const MatchContext& context, const ScanMatch& found) const {
    const ScanMatch odometry = by_odometry(context);
    return lidar_trust(context.degeneracy.degree) * found.score > odometry.score ? found : odometry;
}

ScanMatch OdometryTrust::correct(const MatchContext& context, const ScanMatch& /*found*/) const {
    return by_odometry(context);
}

ScanMatch EigenvalueGate::correct(const MatchContext& context, const ScanMatch& found) const {
    const Eigen::Matrix2d position = found.information.topLeftCorner<2, 2>();
    const Eigen::Vector2d eigenvalues =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(position, Eigen::EigenvaluesOnly).eigenvalues();
    const bool held = found.accepted() && eigenvalues(0) > settings_.least_share * eigenvalues(1);
    return held ? found : by_odometry(context);
}

}  // namespace ddtool

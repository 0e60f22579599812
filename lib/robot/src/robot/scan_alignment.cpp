#include "robot/scan_alignment.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "robot/sweep.hpp"

namespace ddtool {
namespace {

constexpr double usable_range_m = 20.0;
constexpr std::size_t most_points = 180;
constexpr double far_m = 0.2;
constexpr int rounds = 8;
/// In the first rounds more distant points pull, too.
constexpr double reach_of_round_m[rounds] = {0.6, 0.6, 0.4, 0.4, 0.2, 0.2, 0.2, 0.2};
/// The guess has the weight of points that lie this far from their lines, so that a corridor, which does not hold the
/// scan along itself, leaves the guess as it is.
constexpr double point_sd_m = 0.03;
constexpr double guess_sd_m = 0.1;
constexpr double guess_sd_rad = 0.1;
/// Points that are farther from each other than this share of their distance from the robot are on two surfaces.
constexpr double gap_share = 0.2;
constexpr double gap_m = 0.1;

/// A point with the line through its two neighbours.
struct LinePoint {
    Point2 at;
    Point2 normal;
};

std::vector<LinePoint> lines_of(const std::vector<Point2>& points_m) {
    std::vector<LinePoint> lines;
    for (std::size_t i = 1; i + 1 < points_m.size(); ++i) {
        const Point2& at = points_m[i];
        const Point2& before = points_m[i - 1];
        const Point2& after = points_m[i + 1];
        const double gap = gap_m + gap_share * std::hypot(at.x_m, at.y_m);
        const double length = std::hypot(after.x_m - before.x_m, after.y_m - before.y_m);
        if (length > 0.0 && std::hypot(at.x_m - before.x_m, at.y_m - before.y_m) < gap &&
            std::hypot(after.x_m - at.x_m, after.y_m - at.y_m) < gap) {
            lines.push_back({at, {(before.y_m - after.y_m) / length, (after.x_m - before.x_m) / length}});
        }
    }
    return lines;
}

const LinePoint* nearest_to(const Point2& point, const std::vector<LinePoint>& lines) {
    const LinePoint* nearest = nullptr;
    double least = INFINITY;
    for (const LinePoint& line : lines) {
        const double dx = line.at.x_m - point.x_m;
        const double dy = line.at.y_m - point.y_m;
        const double apart = dx * dx + dy * dy;
        if (apart < least) {
            least = apart;
            nearest = &line;
        }
    }
    return nearest;
}

/// The distance of a point from the line of the nearest point, which must not be farther away than that line reaches.
struct Distance {
    double across_m = INFINITY;
    Point2 normal;
};

Distance distance_from(const Point2& point, const std::vector<LinePoint>& lines) {
    const LinePoint* nearest = nearest_to(point, lines);
    if (nearest == nullptr) {
        return {};
    }
    const double dx = point.x_m - nearest->at.x_m;
    const double dy = point.y_m - nearest->at.y_m;
    const double along_m = std::abs(nearest->normal.x_m * dy - nearest->normal.y_m * dx);
    const double reach_m = gap_m + gap_share * std::hypot(nearest->at.x_m, nearest->at.y_m);
    return along_m > reach_m ? Distance{}
                             : Distance{nearest->normal.x_m * dx + nearest->normal.y_m * dy, nearest->normal};
}

/// One Gauss-Newton step.
Pose2 improved(const std::vector<LinePoint>& lines, const std::vector<Point2>& second_m, const Pose2& pose,
               const Pose2& guess, double reach_m) {
    Eigen::Matrix3d information = Eigen::Vector3d(1.0 / (guess_sd_m * guess_sd_m), 1.0 / (guess_sd_m * guess_sd_m),
                                                  1.0 / (guess_sd_rad * guess_sd_rad))
                                      .asDiagonal();
    information *= point_sd_m * point_sd_m;
    Eigen::Vector3d gradient = information * Eigen::Vector3d(pose.x_m - guess.x_m, pose.y_m - guess.y_m,
                                                             wrap_angle(pose.theta_rad - guess.theta_rad));
    for (const Point2& point : second_m) {
        const Point2 moved = pose * point;
        const Distance distance = distance_from(moved, lines);
        if (std::abs(distance.across_m) < reach_m) {
            const Eigen::Vector3d slope(
                distance.normal.x_m, distance.normal.y_m,
                distance.normal.y_m * (moved.x_m - pose.x_m) - distance.normal.x_m * (moved.y_m - pose.y_m));
            information += slope * slope.transpose();
            gradient += slope * distance.across_m;
        }
    }
    const Eigen::Vector3d step = -information.ldlt().solve(gradient);
    return {pose.x_m + step.x(), pose.y_m + step.y(), wrap_angle(pose.theta_rad + step.z())};
}

}  // namespace

std::vector<Point2> alignment_points(const SensorFrame& frame, const std::vector<Pose2>& sweep) {
    const std::size_t beams = frame.scan.ranges_m.size();
    const std::size_t step = (beams + most_points - 1) / most_points;
    std::vector<Point2> points_m;
    for (std::size_t beam = 0; beam < beams; beam += step) {
        const auto range_m = static_cast<double>(frame.scan.ranges_m[beam]);
        if (range_m <= usable_range_m) {
            const double angle_rad = frame.scan.angle_rad(beam);
            const Point2 end =
                frame.robot_from_laser * Point2{range_m * std::cos(angle_rad), range_m * std::sin(angle_rad)};
            points_m.push_back(sweep.empty() ? end : pose_in_sweep(sweep, beam, beams) * end);
        }
    }
    return points_m;
}

ScanAlignment align_scans(const std::vector<Point2>& first_m, const std::vector<Point2>& second_m, const Pose2& guess) {
    const std::vector<LinePoint> lines = lines_of(first_m);
    ScanAlignment result{.first_from_second = guess};
    if (lines.empty() || second_m.empty()) {
        return result;
    }
    for (const double reach_m : reach_of_round_m) {
        result.first_from_second = improved(lines, second_m, result.first_from_second, guess, reach_m);
    }
    double sum_m = 0.0;
    std::size_t matched = 0;
    for (const Point2& point : second_m) {
        const double apart_m = std::abs(distance_from(result.first_from_second * point, lines).across_m);
        sum_m += std::min(apart_m, far_m);
        matched += apart_m < far_m ? 1 : 0;
    }
    result.residual_m = sum_m / static_cast<double>(second_m.size());
    result.matched_share = static_cast<double>(matched) / static_cast<double>(second_m.size());
    return result;
}

}  // namespace ddtool

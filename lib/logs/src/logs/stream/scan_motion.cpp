#include "logs/stream/scan_motion.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "logs/stream/scan_turn.hpp"

namespace ddtool {
namespace {

constexpr std::size_t most_points = 400;
constexpr std::size_t least_points = 20;
/// Over this length a wall's direction is known to three degrees where ranges err by a centimetre.
constexpr double line_m = 0.25;
constexpr std::size_t most_line_points = 25;  ///< on either side
constexpr double gap_on_line_m = 0.3;         ///< neighbours that differ by more are not on one surface
constexpr double off_line_m = 0.04;           ///< a point farther from the ends' line is at a corner
/// In the first rounds, of a motion that is not known yet, more distant points count, too.
constexpr std::array<double, 8> reach_m{0.5, 0.5, 0.5, 0.3, 0.3, 0.15, 0.15, 0.15};
/// By how much the bearing of a point may change because the lidar moves sideways. Points nearer than twice the motion
/// are left out.
constexpr double most_parallax = 0.5;
constexpr double least_in_reach = 0.5;  ///< share of the compared points
/// So much of the information that points could have, if all surfaces lay across a direction, they must have in every
/// direction. What the noise of the lines feigns is a tenth of it.
constexpr double least_held = 0.05;

struct LineOfScan {
    Eigen::Vector2d at;
    Eigen::Vector2d normal;
};

/// The end point of a beam, with its range; NaN where there is none.
struct EndPoint {
    Eigen::Vector2d at;
    double range_m;
};

/// The directions of every few beams.
std::vector<Eigen::Vector2d> beam_directions(const LaserScan& scan, std::size_t every) {
    std::vector<Eigen::Vector2d> directions;
    for (std::size_t beam = 0; beam < scan.ranges_m.size(); beam += every) {
        directions.emplace_back(std::cos(scan.angle_rad(beam)), std::sin(scan.angle_rad(beam)));
    }
    return directions;
}

std::vector<EndPoint> points_of(const LaserScan& scan, std::size_t every,
                                const std::vector<Eigen::Vector2d>& directions) {
    const double most_m = scan.range_max_m > 0.0 ? scan.range_max_m : INFINITY;
    std::vector<EndPoint> points;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const auto logged_m = static_cast<double>(scan.ranges_m[i * every]);
        const bool is_range = std::isfinite(logged_m) && logged_m > 0.0 && logged_m < most_m;
        const double range_m = is_range ? logged_m : NAN;
        points.push_back({range_m * directions[i], range_m});
    }
    return points;
}

std::optional<LineOfScan> line_at(const std::vector<EndPoint>& points, std::size_t i) {
    const auto is_near = [&](std::size_t a, std::size_t b) {
        return std::abs(points[a].range_m - points[b].range_m) < gap_on_line_m;
    };
    for (std::size_t k = 1; k <= most_line_points && k <= i && i + k < points.size(); ++k) {
        if (!is_near(i - k, i - k + 1) || !is_near(i + k, i + k - 1)) {
            return std::nullopt;
        }
        const Eigen::Vector2d chord = points[i + k].at - points[i - k].at;
        if (chord.squaredNorm() >= line_m * line_m) {
            const Eigen::Vector2d normal = Eigen::Vector2d(-chord.y(), chord.x()).normalized();
            const bool is_straight = std::abs(normal.dot(points[i].at - points[i - k].at)) < off_line_m;
            return is_straight ? std::optional(LineOfScan{points[i].at, normal}) : std::nullopt;
        }
    }
    return std::nullopt;
}

std::vector<std::optional<LineOfScan>> lines_at(const std::vector<EndPoint>& points) {
    std::vector<std::optional<LineOfScan>> lines;
    for (std::size_t i = 0; i < points.size(); ++i) {
        lines.push_back(line_at(points, i));
    }
    return lines;
}

/// What one round of Gauss and Newton gathers; the unknowns are turn, x and y.
struct Normals {
    Eigen::Matrix3d information = Eigen::Matrix3d::Identity() * 1e-9;
    Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
    std::size_t compared = 0;
    std::size_t in_reach = 0;
};

/// The share of the possible information about the position in the direction that has least of it.
double least_information(const Normals& normals) {
    const Eigen::Matrix3d& all = normals.information;
    const Eigen::Vector2d with_turn = all.block<2, 1>(1, 0);
    const Eigen::Matrix2d position = all.bottomRightCorner<2, 2>() - with_turn * with_turn.transpose() / all(0, 0);
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(position).eigenvalues().minCoeff() /
           static_cast<double>(normals.in_reach);
}

}  // namespace

std::optional<Pose2> motion_between(const LaserScan& before, const LaserScan& after) {
    const std::optional<double> turn_rad = turn_between(before, after);
    if (!turn_rad) {
        return std::nullopt;
    }
    const std::size_t every = (before.ranges_m.size() + most_points - 1) / most_points;
    const double step_rad = before.angle_increment_rad * static_cast<double>(every);
    const double beams_of_circle = 2.0 * std::numbers::pi / std::abs(step_rad);
    const std::vector<Eigen::Vector2d> directions = beam_directions(before, every);
    const std::vector<std::optional<LineOfScan>> lines = lines_at(points_of(before, every, directions));
    const std::vector<EndPoint> points = points_of(after, every, directions);
    Eigen::Vector3d motion(*turn_rad, 0.0, 0.0);
    Normals normals;
    for (const double reach : reach_m) {
        normals = {};
        const Eigen::Rotation2Dd rotation(motion(0));
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Eigen::Vector2d turned = rotation * points[i].at;
            const Eigen::Vector2d moved = turned + motion.tail<2>();
            // The tangent of the angle between the two, the arc of which is given well enough by two terms.
            const double tangent = (turned.x() * moved.y() - turned.y() * moved.x()) / turned.dot(moved);
            if (!(std::abs(tangent) < most_parallax)) {
                continue;
            }
            const double bearing_rad = motion(0) + tangent * (1.0 - tangent * tangent / 3.0);
            const double place = static_cast<double>(i) + bearing_rad / step_rad;
            const double beam = std::round(place < -0.5                                 ? place + beams_of_circle
                                           : place >= static_cast<double>(lines.size()) ? place - beams_of_circle
                                                                                        : place);
            if (!(beam >= 0.0 && beam < static_cast<double>(lines.size()))) {
                continue;
            }
            const std::optional<LineOfScan>& line = lines[static_cast<std::size_t>(beam)];
            if (!line) {
                continue;
            }
            ++normals.compared;
            const double residual_m = line->normal.dot(moved - line->at);
            if (std::abs(residual_m) < reach) {
                ++normals.in_reach;
                const Eigen::Vector3d slope(line->normal.dot(Eigen::Vector2d(-turned.y(), turned.x())),
                                            line->normal.x(), line->normal.y());
                normals.information += slope * slope.transpose();
                normals.gradient += residual_m * slope;
            }
        }
        motion -= normals.information.ldlt().solve(normals.gradient);
    }
    const bool fits = normals.in_reach >= least_points &&
                      static_cast<double>(normals.in_reach) >= least_in_reach * static_cast<double>(normals.compared);
    return fits && least_information(normals) >= least_held ? std::optional(Pose2{motion(1), motion(2), motion(0)})
                                                            : std::nullopt;
}

}  // namespace ddtool

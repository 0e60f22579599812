#include "ddtool/robot/scan_points.hpp"

#include <algorithm>
#include <cmath>

#include "robot/principal_axes.hpp"
#include "robot/sweep.hpp"

namespace ddtool {
namespace {

/// Number of neighbours of a point, and the sums of their coordinates and of the products of these, relative to the
/// point.
struct Moments {
    double count = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;

    void add(double dx, double dy) {
        count += 1.0;
        x += dx;
        y += dy;
        xx += dx * dx;
        xy += dx * dy;
        yy += dy * dy;
    }
};

/// A point and its neighbours: all of them, and those alone between which and the point the range does not jump.
struct Neighbours {
    Moments all, on_surface;
};

constexpr std::size_t most_neighbours_each_side = 12;
/// These neighbours are taken at any distance: the end points on a wall far ahead are metres apart and still show its
/// direction.
constexpr std::size_t least_neighbours_each_side = 2;
/// A line needs at least this many points, the point itself included. A point at the end of a run has neighbours on one
/// side only, and two of them are always taken.
constexpr double points_of_a_line = 3.0;

/// Adds the neighbours on one side of `point` as long as they come from adjacent beams; `step` is 1 or -1.
void add_side(const ScanPoints& points, std::size_t point, int step, double radius_m, Neighbours& neighbours) {
    std::size_t last = point;
    bool on_surface = true;
    for (std::size_t taken = 0; taken < most_neighbours_each_side; ++taken) {
        // Below 0 the unsigned index wraps around to a huge one, which ends the loop.
        const std::size_t next = last + static_cast<std::size_t>(step);
        if (next >= points.size() || std::abs(points.order[next] - points.order[last]) >= ScanPoints::order_gap) {
            return;
        }
        const double dx = static_cast<double>(points.x_m[next]) - static_cast<double>(points.x_m[point]);
        const double dy = static_cast<double>(points.y_m[next]) - static_cast<double>(points.y_m[point]);
        if (taken >= least_neighbours_each_side && dx * dx + dy * dy > radius_m * radius_m) {
            return;
        }
        on_surface = on_surface && std::abs(points.order[next] - points.order[last]) < ScanPoints::order_jump;
        neighbours.all.add(dx, dy);
        if (on_surface) {
            neighbours.on_surface.add(dx, dy);
        }
        last = next;
    }
}

/// The neighbours that show the direction of a point's surface: those on it, so that at the edge of a recess the normal
/// does not tilt towards the wall behind. Where they are too few for a line, all count, since a point without a line
/// would hold the robot in every direction.
Moments neighbourhood(const ScanPoints& points, std::size_t point) {
    Neighbours neighbours;
    neighbours.all.add(0.0, 0.0);
    neighbours.on_surface.add(0.0, 0.0);
    add_side(points, point, 1, ScanPoints::normal_radius_m, neighbours);
    add_side(points, point, -1, ScanPoints::normal_radius_m, neighbours);
    return neighbours.on_surface.count >= points_of_a_line ? neighbours.on_surface : neighbours.all;
}

/// If the neighbours extend along their line by more than normal_radius_m (standard deviation), they belong to one
/// surface only if their standard deviation across the line is at most this.
constexpr double far_line_residual_m = 0.04;

void set_normal(ScanPoints& points, std::size_t point) {
    const Moments m = neighbourhood(points, point);
    if (m.count < points_of_a_line) {
        return;
    }
    const double xx = m.xx / m.count - m.x * m.x / (m.count * m.count);
    const double xy = m.xy / m.count - m.x * m.y / (m.count * m.count);
    const double yy = m.yy / m.count - m.y * m.y / (m.count * m.count);
    const PrincipalAxes axes = principal_axes(xx, xy, yy);
    const double smallest = std::max(axes.smaller, 0.0);
    if (std::sqrt(axes.larger) > ScanPoints::normal_radius_m && std::sqrt(smallest) > far_line_residual_m) {
        return;
    }
    points.normal_x[point] = static_cast<float>(-std::sin(axes.direction_rad));
    points.normal_y[point] = static_cast<float>(std::cos(axes.direction_rad));
    const double flatness = std::sqrt(smallest / std::max(axes.larger, 1e-12));
    const double roughness =
        std::clamp((flatness - ScanPoints::line_flatness) / (1.0 - ScanPoints::line_flatness), 0.0, 1.0);
    points.along_weight[point] = static_cast<float>(roughness * roughness);
}

/// The range at which the next beam ends if the last two beams met a straight wall that continues: along a straight
/// wall the inverse of the range is linear in the angle, for small angles.
double continued_m(double before_m, double last_m) { return 1.0 / (2.0 / last_m - 1.0 / before_m); }

/// Two ranges are apart if they differ by more than gap_m + gap_per_m * range.
double gap_at(double range_m) {
    constexpr double gap_m = 0.05;
    constexpr double gap_per_m = 0.01;
    return gap_m + gap_per_m * range_m;
}

/// Whether the range of a beam is a mixture of two surfaces, because the beam met the edge of the nearer one (a veiling
/// or mixed point). Such a range lies between those of the two neighbouring beams, is apart from both, and continues
/// the wall of neither. At the edges of recesses and doors, such points float between the surfaces; if they enter the
/// map, every corridor comes out too long.
bool is_mixed(const std::vector<float>& ranges_m, std::size_t beam) {
    if (beam < 2 || beam + 2 >= ranges_m.size()) {
        return false;
    }
    const auto range_m = [&](std::size_t index) { return static_cast<double>(ranges_m[index]); };
    if (!std::isfinite(range_m(beam - 1)) || !std::isfinite(range_m(beam + 1))) {
        return false;
    }
    const double here_m = range_m(beam);
    const auto apart = [&](double other_m) { return !(std::abs(here_m - other_m) <= gap_at(here_m)); };
    const bool between = (range_m(beam - 1) < here_m) == (here_m < range_m(beam + 1));
    return between && apart(range_m(beam - 1)) && apart(range_m(beam + 1)) &&
           apart(continued_m(range_m(beam - 2), range_m(beam - 1))) &&
           apart(continued_m(range_m(beam + 2), range_m(beam + 1)));
}

/// The standard deviation of the ranges, from how far each is apart from the line through its two neighbours (in
/// inverse ranges, as in continued_m()). The median leaves out corners and edges, where that is no noise. 0 where the
/// ranges do not tell.
double range_noise_m(const std::vector<float>& ranges_m) {
    std::vector<double> bends_m;
    for (std::size_t beam = 1; beam + 1 < ranges_m.size(); ++beam) {
        const auto before_m = static_cast<double>(ranges_m[beam - 1]);
        const auto here_m = static_cast<double>(ranges_m[beam]);
        const auto after_m = static_cast<double>(ranges_m[beam + 1]);
        const double bend_m = std::abs(here_m * here_m * (1.0 / before_m - 2.0 / here_m + 1.0 / after_m));
        if (std::isfinite(before_m) && std::isfinite(after_m) && std::isfinite(bend_m)) {
            bends_m.push_back(bend_m);
        }
    }
    if (bends_m.empty()) {
        return 0.0;
    }
    const auto middle = bends_m.begin() + static_cast<std::ptrdiff_t>(bends_m.size() / 2);
    std::nth_element(bends_m.begin(), middle, bends_m.end());
    // A bend is the sum of ranges with the factors 1, -2 and 1; the median of a normal distribution's absolute values
    // is this share of its standard deviation.
    constexpr double median_share = 0.6745;
    return *middle / (median_share * std::sqrt(6.0));
}

/// Whether a beam, which is not the first, meets another surface than the beam before it: their ranges are apart, and
/// neither does the wall before the jump continue behind it nor the other way round. Where no beam shows how a wall
/// continues, it does not. Noise must not look like a jump, since the normal of a short piece of wall is uncertain:
/// with 6 deviations the plain difference is 4.2 of its own deviations, and the two continuations, which have to agree
/// with it, 2.4 each.
bool jumps_before(const std::vector<float>& ranges_m, std::size_t beam, double noise_m) {
    constexpr double noise_deviations = 6.0;
    const auto range_m = [&](std::size_t index) { return static_cast<double>(ranges_m[index]); };
    const double before_m = range_m(beam - 1);
    const double here_m = range_m(beam);
    const auto apart = [&](double a_m, double b_m) {
        return !(std::abs(a_m - b_m) <= std::max(gap_at(std::min(before_m, here_m)), noise_deviations * noise_m));
    };
    return apart(here_m, before_m) && (beam < 2 || apart(here_m, continued_m(range_m(beam - 2), before_m))) &&
           (beam + 1 == ranges_m.size() || apart(before_m, continued_m(range_m(beam + 1), here_m)));
}

/// Neighbouring end points that are merged to one.
struct Group {
    Point2 first;
    Point2 sum;
    double count = 0.0;

    [[nodiscard]] bool takes(const Point2& end, double spacing_m) const {
        return count > 0.0 && std::hypot(end.x_m - first.x_m, end.y_m - first.y_m) < spacing_m;
    }
    void add(const Point2& end) {
        if (count == 0.0) {
            first = end;
        }
        sum = {sum.x_m + end.x_m, sum.y_m + end.y_m};
        count += 1.0;
    }
};

void close_group(ScanPoints& points, Group& group, std::int32_t order) {
    if (group.count > 0.0) {
        points.x_m.push_back(static_cast<float>(group.sum.x_m / group.count));
        points.y_m.push_back(static_cast<float>(group.sum.y_m / group.count));
        points.order.push_back(order);
    }
    group = {};
}

/// The laser in the robot's frame at the stamp, when a beam is measured.
class LaserPlaces {
public:
    LaserPlaces(const SensorFrame& frame, bool deskew) : frame_(frame), moves_(deskew && !frame.sweep.empty()) {}

    [[nodiscard]] Pose2 at(std::size_t beam) const {
        return moves_ ? pose_in_sweep(frame_.sweep, beam, frame_.scan.ranges_m.size()) * frame_.robot_from_laser
                      : frame_.robot_from_laser;
    }

private:
    const SensorFrame& frame_;
    bool moves_;
};

void add_end_points(ScanPoints& points, const SensorFrame& frame, const LaserPlaces& robot_from_laser,
                    const ScanPointsSettings& settings) {
    const double noise_m = range_noise_m(frame.scan.ranges_m);
    Group group;
    std::int32_t order = 0;
    for (std::size_t beam = 0; beam < frame.scan.ranges_m.size(); ++beam) {
        const auto range_m = static_cast<double>(frame.scan.ranges_m[beam]);
        if (!(range_m <= settings.usable_range_m)) {
            close_group(points, group, order);
            // With the increment for the next point, `order` then rises by 3 or more across the gap.
            order += ScanPoints::order_gap - 1;
            continue;
        }
        if (is_mixed(frame.scan.ranges_m, beam)) {
            continue;
        }
        if (beam > 0 && jumps_before(frame.scan.ranges_m, beam, noise_m)) {
            close_group(points, group, order);
            order += ScanPoints::order_jump - 1;
        }
        const double angle = frame.scan.angle_rad(beam);
        const Point2 end = robot_from_laser.at(beam) * Point2{range_m * std::cos(angle), range_m * std::sin(angle)};
        if (!group.takes(end, settings.spacing_m)) {
            close_group(points, group, order);
            ++order;
        }
        group.add(end);
    }
    close_group(points, group, order);
}

/// The points of the frame's own scan.
ScanPoints own_points(const SensorFrame& frame, const ScanPointsSettings& settings) {
    ScanPoints points;
    const LaserPlaces robot_from_laser(frame, settings.deskew);
    const Pose2 middle = robot_from_laser.at(frame.scan.ranges_m.size() / 2);
    points.origin_m = {middle.x_m, middle.y_m};
    add_end_points(points, frame, robot_from_laser, settings);
    points.normal_x.assign(points.size(), 1.0F);
    points.normal_y.assign(points.size(), 0.0F);
    points.along_weight.assign(points.size(), 1.0F);
    for (std::size_t point = 0; point < points.size(); ++point) {
        set_normal(points, point);
    }
    return points;
}

/// Adds the points of another lidar's scan.
/// \param robot_from_then the robot at the stamp of that scan, in its frame at the stamp of `points`
void join(ScanPoints& points, const ScanPoints& other, const Pose2& robot_from_then) {
    const Pose2 turn{0.0, 0.0, robot_from_then.theta_rad};
    const std::int32_t order = points.size() == 0 ? 0 : points.order.back() + ScanPoints::order_gap;
    points.joined.push_back({robot_from_then * other.origin_m, points.size()});
    for (std::size_t i = 0; i < other.size(); ++i) {
        const Point2 end =
            robot_from_then * Point2{static_cast<double>(other.x_m[i]), static_cast<double>(other.y_m[i])};
        const Point2 normal =
            turn * Point2{static_cast<double>(other.normal_x[i]), static_cast<double>(other.normal_y[i])};
        points.x_m.push_back(static_cast<float>(end.x_m));
        points.y_m.push_back(static_cast<float>(end.y_m));
        points.normal_x.push_back(static_cast<float>(normal.x_m));
        points.normal_y.push_back(static_cast<float>(normal.y_m));
        points.along_weight.push_back(other.along_weight[i]);
        points.order.push_back(order + other.order[i]);
    }
}

}  // namespace

ScanPoints scan_points(const SensorFrame& frame, const ScanPointsSettings& settings) {
    ScanPoints points = own_points(frame, settings);
    for (const SensorFrame& other : frame.joined) {
        join(points, own_points(other, settings), between(frame.odom_from_robot, other.odom_from_robot));
    }
    return points;
}

}  // namespace ddtool

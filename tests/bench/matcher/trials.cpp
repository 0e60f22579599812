#include "trials.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <optional>

#include "filter/pose_covariance.hpp"

namespace ddtool::matcher_bench {
namespace {

constexpr std::uint64_t displacement_draw = 102;

/// From the true pose to another, in the axes along, across and heading.
Eigen::Vector3d error_of(const Pose2& pose, const Place& place) {
    const Pose2& truth = place.pose();
    const Eigen::Vector3d in_world(pose.x_m - truth.x_m, pose.y_m - truth.y_m,
                                   wrap_angle(pose.theta_rad - truth.theta_rad));
    return turned_about_z(place.along_rad).transpose() * in_world;
}

/// A map, and the scans that enter it at the filter's distances.
class DrivenMap {
public:
    explicit DrivenMap(const RbpfSettings& filter) : filter_(filter), grid_(filter.grid) {}

    [[nodiscard]] const OccupancyGrid& grid() const { return grid_; }

    void enter(const Place& place) {
        if (last_) {
            const Pose2 since = between(*last_, place.pose());
            if (std::hypot(since.x_m, since.y_m) < filter_.insert_distance_m &&
                std::abs(since.theta_rad) < filter_.insert_turn_rad) {
                return;
            }
        }
        last_ = place.pose();
        inserter_.insert(grid_, scan_points(place.frame, filter_.points), place.pose());
    }

private:
    RbpfSettings filter_;
    OccupancyGrid grid_;
    ScanInserter inserter_;
    std::optional<Pose2> last_;
};

class Trials {
public:
    explicit Trials(const TrialSettings& settings)
        : settings_(settings),
          matcher_(settings.filter.matcher, settings.filter.grid.cell_size_m),
          first_step_matcher_(one_step(settings.filter.matcher), settings.filter.grid.cell_size_m) {}

    Trial at(const Place& place, std::uint64_t index, const OccupancyGrid& grid) {
        const Pose2& truth = place.pose();
        const MatchPoints points(scan_points(place.frame, settings_.filter.points), grid.cell_size_m());
        const Pose2 predicted = truth * draw_displacement(index);
        const ScanMatch match = matcher_.match(grid, points, truth, settings_.prior);
        const ScanMatch displaced = matcher_.match(grid, points, predicted, settings_.prior);
        const ScanMatch first = first_step_matcher_.match(grid, points, truth, settings_.prior);
        return {.way_m = place.way_m,
                .accepted = match.accepted() && displaced.accepted(),
                .first_step = error_of(first.pose, place),
                .error = error_of(match.pose, place),
                .displacement = error_of(predicted, place),
                .error_displaced = error_of(displaced.pose, place),
                .bound = deviations(place.information, truth.theta_rad - place.along_rad),
                .believed = deviations(match.information, -place.along_rad)};
    }

private:
    static ScanMatcherSettings one_step(ScanMatcherSettings settings) {
        settings.max_iterations = 1;
        settings.doubtful_score = 0.0;  // without the wide search
        return settings;
    }

    [[nodiscard]] Pose2 draw_displacement(std::uint64_t index) const {
        RandomStream random({settings_.seed, displacement_draw, index});
        const double x_m = random.uniform(-settings_.displacement_m, settings_.displacement_m);
        const double y_m = random.uniform(-settings_.displacement_m, settings_.displacement_m);
        return {x_m, y_m, random.uniform(-settings_.displacement_rad, settings_.displacement_rad)};
    }

    /// Standard deviations along the axes that a scan and the prior leave.
    /// \param information of the scan, in a frame that has the heading `heading_rad` in the frame of the axes
    [[nodiscard]] Eigen::Vector3d deviations(const Eigen::Matrix3d& information, double heading_rad) const {
        const Eigen::Matrix3d turn = turned_about_z(heading_rad);
        const Eigen::Matrix3d sum = turn * information * turn.transpose() + information_of(settings_.prior, 0.0);
        return sum.inverse().diagonal().cwiseSqrt();
    }

    TrialSettings settings_;
    ScanMatcher matcher_;
    ScanMatcher first_step_matcher_;
};

}  // namespace

std::vector<Trial> match_at_frontier(const std::vector<Place>& places, const TrialSettings& settings) {
    Trials trials(settings);
    DrivenMap map(settings.filter);
    std::vector<Trial> result;
    for (std::size_t index = 0; index < places.size(); ++index) {
        if (index > 0) {
            result.push_back(trials.at(places[index], index, map.grid()));
        }
        map.enter(places[index]);
    }
    return result;
}

std::vector<Trial> match_in_known_map(const std::vector<Place>& mapped, const std::vector<Place>& places,
                                      const TrialSettings& settings) {
    DrivenMap map(settings.filter);
    for (const Place& place : mapped) {
        map.enter(place);
    }
    Trials trials(settings);
    std::vector<Trial> result;
    for (std::size_t index = 0; index < places.size(); ++index) {
        result.push_back(trials.at(places[index], index, map.grid()));
    }
    return result;
}

double drift(const std::vector<Place>& places, const TrialSettings& settings) {
    RbpfSettings single = settings.filter;
    single.particles = 1;
    single.seed = settings.seed;
    ThreadPool threads(1);
    Rbpf filter(single, threads);
    double excess_m = 0.0;
    std::optional<Pose2> believed_before;
    const Place* before = nullptr;
    for (const Place& place : places) {
        const std::optional<Update> update = filter.update(place.frame);
        if (!update) {
            continue;
        }
        if (believed_before) {
            excess_m += between(*believed_before, update->pose).x_m - between(before->pose(), place.pose()).x_m;
        }
        believed_before = update->pose;
        before = &place;
    }
    return excess_m / places.back().way_m;
}

}  // namespace ddtool::matcher_bench

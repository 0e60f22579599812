#include "trials.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <ctime>

#include "base/squared.hpp"
#include "ddtool/base/random.hpp"
#include "localization/localizer.hpp"

namespace ddtool::localization_bench {
namespace {

using localization::LocalizationSettings;
using localization::Localizer;

/// A place counts as right up to this distance from the truth.
constexpr double right_m = 0.5;
constexpr double right_rad = 0.2;
constexpr double sure = 0.9;

double cpu_s() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

class Trial {
public:
    Trial(const MadeMap& map, const LocalizationSettings& settings, std::optional<localization::StartPose> start)
        : map_(map),
          localizer_(with_cells(settings), settings.particles, threads_, make_strategies(settings.filter, {}), map.grid,
                     start) {}

    std::optional<Update> update(const SensorFrame& frame) {
        std::optional<Update> update = localizer_.update(frame);
        if (update) {
            truth_ = map_.map_from_world * *frame.world_from_robot;
            way_m_ += std::hypot(update->matched.odometry_motion.x_m, update->matched.odometry_motion.y_m);
        }
        return update;
    }
    [[nodiscard]] const Pose2& truth() const { return truth_; }
    [[nodiscard]] double way_m() const { return way_m_; }
    [[nodiscard]] const localization::Standing& standing() const { return localizer_.standing(); }
    [[nodiscard]] bool is_right(const Update& update) const {
        return distance_m(update.pose, truth_) < right_m &&
               std::abs(wrap_angle(update.pose.theta_rad - truth_.theta_rad)) < right_rad;
    }

private:
    RbpfSettings with_cells(const LocalizationSettings& settings) const {
        RbpfSettings rbpf = settings.filter.rbpf;
        rbpf.grid = map_.grid->settings();
        return rbpf;
    }

    const MadeMap& map_;
    ThreadPool threads_{1};
    Localizer localizer_;
    Pose2 truth_;
    double way_m_ = 0.0;
};

class ErrorMeans {
public:
    void add(const Update& update, const Pose2& truth) {
        const Eigen::Vector2d apart(update.pose.x_m - truth.x_m, update.pose.y_m - truth.y_m);
        const double position = apart.dot(update.covariance.topLeftCorner<2, 2>().inverse() * apart);
        const double heading = squared(wrap_angle(update.pose.theta_rad - truth.theta_rad)) / update.covariance(2, 2);
        ++updates_;
        sums_.ate_m += apart.squaredNorm();
        sums_.worst_m = std::max(sums_.worst_m, apart.norm());
        sums_.nees_position += position;
        sums_.nees_heading += heading;
        sums_.within_position += position <= chi_square_of_two ? 1.0 : 0.0;
        sums_.within_heading += heading <= chi_square_of_one ? 1.0 : 0.0;
    }
    [[nodiscard]] Errors means() const {
        return {.ate_m = std::sqrt(sums_.ate_m / updates_),
                .worst_m = sums_.worst_m,
                .nees_position = sums_.nees_position / updates_,
                .nees_heading = sums_.nees_heading / updates_,
                .within_position = sums_.within_position / updates_,
                .within_heading = sums_.within_heading / updates_};
    }

private:
    /// Quantiles of .95.
    static constexpr double chi_square_of_two = 5.991;
    static constexpr double chi_square_of_one = 3.841;

    Errors sums_;
    double updates_ = 0.0;
};

}  // namespace

Followed follow(const MadeMap& map, const std::vector<SensorFrame>& frames, const LocalizationSettings& settings) {
    const Pose2 start = map.map_from_world * *frames.front().world_from_robot;
    RandomStream random({7, static_cast<std::uint64_t>(frames.front().scan.stamp_ns)});
    // Along a corridor nothing but the start tells where the robot is, so that its error would hide all others.
    constexpr double start_sd_m = 0.02;
    constexpr double start_sd_rad = 0.01;
    const localization::StartPose given{
        {start.x_m + start_sd_m * random.normal(), start.y_m + start_sd_m * random.normal(),
         start.theta_rad + start_sd_rad * random.normal()},
        start_sd_m,
        start_sd_rad};
    Trial trial(map, settings, given);
    Followed followed;
    ErrorMeans in_building, in_map;
    double updates = 0.0;
    const double before_s = cpu_s();
    for (const SensorFrame& frame : frames) {
        const std::optional<Update> update = trial.update(frame);
        if (!update) {
            continue;
        }
        ++updates;
        followed.particles += static_cast<double>(trial.standing().particles);
        followed.sure_share += trial.standing().probability >= sure ? 1.0 : 0.0;
        in_building.add(*update, trial.truth());
        in_map.add(*update, map.in_map(*frame.world_from_robot));
    }
    followed.cpu_ms = 1e3 * (cpu_s() - before_s) / updates;
    followed.in_building = in_building.means();
    followed.in_map = in_map.means();
    followed.particles /= updates;
    followed.sure_share /= updates;
    return followed;
}

Started start_anywhere(const MadeMap& map, const std::vector<SensorFrame>& frames, std::size_t from, double way_m,
                       const LocalizationSettings& settings) {
    Trial trial(map, settings, std::nullopt);
    Started started;
    for (std::size_t index = from; index < frames.size() && trial.way_m() < way_m; ++index) {
        const std::optional<Update> update = trial.update(frames[index]);
        if (!update) {
            continue;
        }
        started.right = trial.is_right(*update);
        const bool is_sure = trial.standing().probability >= sure;
        started.confidently_wrong = started.confidently_wrong || (is_sure && !started.right);
        if (!started.right) {
            started.right_after_m.reset();
        } else if (is_sure && !started.right_after_m) {
            started.right_after_m = trial.way_m();
        }
    }
    return started;
}

Kidnapped kidnap(const MadeMap& map, const std::vector<SensorFrame>& frames, std::size_t from, std::size_t to,
                 double way_m, const LocalizationSettings& settings) {
    constexpr double before_m = 5.0;
    Trial trial(map, settings,
                localization::StartPose{.pose = map.map_from_world * *frames[from].world_from_robot, .sd_m = 0.2});
    std::size_t last = from;
    for (std::size_t index = from; index < frames.size() && trial.way_m() < before_m; ++index) {
        trial.update(frames[index]);
        last = index;
    }
    Kidnapped kidnapped;
    const Pose2 odom_from_odom = frames[last].odom_from_robot * inverse(frames[to].odom_from_robot);
    const std::int64_t later_ns = frames[last].scan.stamp_ns - frames[to].scan.stamp_ns;
    const double start_m = trial.way_m();
    for (std::size_t index = to; index < frames.size() && trial.way_m() < start_m + way_m; ++index) {
        SensorFrame frame = frames[index];
        frame.odom_from_robot = odom_from_odom * frame.odom_from_robot;
        frame.scan.stamp_ns += later_ns;
        const std::optional<Update> update = trial.update(frame);
        if (!update) {
            continue;
        }
        const double driven_m = trial.way_m() - start_m;
        const bool is_noticed = trial.standing().probability < 0.5 || trial.is_right(*update);
        if (is_noticed && !kidnapped.noticed_after_m) {
            kidnapped.noticed_after_m = driven_m;
        }
        if (!trial.is_right(*update)) {
            kidnapped.mended_after_m.reset();
        } else if (trial.standing().probability >= sure && !kidnapped.mended_after_m) {
            kidnapped.mended_after_m = driven_m;
        }
    }
    return kidnapped;
}

}  // namespace ddtool::localization_bench

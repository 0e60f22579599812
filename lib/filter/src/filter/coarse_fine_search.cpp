#include "ddtool/filter/coarse_fine_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace ddtool {
namespace {

/// Hill climbing on the matcher's score. One step moves to the best of ten poses around the present one (eight shifts,
/// two turns), unless the present one is better.
class Climb {
public:
    Climb(const MatchContext& context, const Pose2& start)
        : context_(context), best_(start), best_score_(score(start)) {}

    void step(double step_m, double turn_rad) {
        for (const Pose2& pose : poses_around(best_, step_m, turn_rad)) {
            consider(pose);
        }
    }
    [[nodiscard]] const Pose2& best() const { return best_; }

private:
    [[nodiscard]] double score(const Pose2& pose) const {
        return context_.matcher.score(context_.grid, context_.points, pose, search_stride);
    }
    void consider(const Pose2& pose) {
        const double pose_score = score(pose);
        if (pose_score > best_score_) {
            best_ = pose;
            best_score_ = pose_score;
        }
    }

    const MatchContext& context_;
    Pose2 best_;
    double best_score_;
};

}  // namespace

std::array<Pose2, 10> poses_around(const Pose2& centre, double step_m, double turn_rad) {
    constexpr std::size_t directions = 8;
    std::array<Pose2, directions + 2> poses;
    for (std::size_t direction = 0; direction < directions; ++direction) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(direction) / directions;
        poses[direction] = {centre.x_m + step_m * std::cos(angle), centre.y_m + step_m * std::sin(angle),
                            centre.theta_rad};
    }
    poses[directions] = {centre.x_m, centre.y_m, wrap_angle(centre.theta_rad - turn_rad)};
    poses[directions + 1] = {centre.x_m, centre.y_m, wrap_angle(centre.theta_rad + turn_rad)};
    return poses;
}

std::size_t search_count(double degree) {
    return 1 + static_cast<std::size_t>(std::floor(std::clamp(degree, 0.0, 1.0) / 0.25));
}

ScanMatch CoarseFineSearch::correct(const MatchContext& context, const ScanMatch& found) const {
    Climb climb(context, found.pose);
    coarse_to_fine(settings_, context.degeneracy.degree,
                   [&](double step_m, double turn_rad) { climb.step(step_m, turn_rad); });
    if (climb.best() == found.pose) {
        return found;
    }
    const ScanMatch searched = context.matcher.evaluate(context.grid, context.points, climb.best());
    return searched.score > found.score ? searched : found;
}

}  // namespace ddtool

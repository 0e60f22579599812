#include "ddtool/filter/failed_match.hpp"

#include "ddtool/filter/odometry_trust.hpp"

namespace ddtool {
namespace {

HillClimb::Found searched(const CoarseFineSettings& settings, HillClimb& matcher, const HitMap& map,
                          std::span<const Point2> ends, const HillClimb::Found& found, double degree) {
    HillClimb::Found best = found;
    coarse_to_fine(settings, degree, [&](double step_m, double turn_rad) {
        for (const Pose2& pose : poses_around(best.pose, step_m, turn_rad)) {
            const BeamFit fit = matcher.fit(map, ends, pose);
            if (fit.score > best.fit.score) {
                best = {pose, fit};
            }
        }
    });
    return best;
}

}  // namespace

HillClimb::Found rescued(const FailedMatchSettings& settings, HillClimb& matcher, const HitMap& map,
                         std::span<const Point2> ends, std::size_t beams, const HillClimb::Found& found,
                         const Pose2& predicted, double degree) {
    const double trust = lidar_trust(degree);
    if (trust * found.fit.score > settings.least_score * static_cast<double>(beams)) {
        return found;
    }
    const HillClimb::Found best =
        settings.search ? searched(*settings.search, matcher, map, ends, found, degree) : found;
    if (!settings.weighs_odometry) {
        return best;
    }
    const BeamFit odometry = matcher.fit(map, ends, predicted);
    return trust * best.fit.score > odometry.score ? best : HillClimb::Found{predicted, odometry};
}

}  // namespace ddtool

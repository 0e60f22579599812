#include "check/verdict.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <optional>

#include "base/text.hpp"

namespace ddtool::check {
namespace {

/// What one rule found.
struct Finding {
    Standing standing = Standing::doubtful;
    std::string reason;
};
using Found = std::optional<Finding>;

std::string percent(double share) { return fixed_text(100.0 * share, share < 0.1 ? 1 : 0) + " %"; }
std::string metres(double length_m) { return fixed_text(length_m, 2) + " m"; }

/// Fewer pairs of scans are too few for a share of them to mean anything.
constexpr std::size_t fewest_pairs = 20;

/// From one scan to the next hardly anything can change: of pairs from healthy logs at most 0.5 % contradict each
/// other, people who walk past the lidar included. Ten times that is a fault, forty times that refutes the path.
Found neighbours_disagree(const Evidence& evidence) {
    constexpr double doubtful_share = 0.05;
    constexpr double refuted_share = 0.2;
    const PairEvidence& pairs = evidence.neighbours;
    if (pairs.pairs < fewest_pairs || pairs.bad <= doubtful_share) {
        return std::nullopt;
    }
    return Finding{
        pairs.bad > refuted_share ? Standing::refuted : Standing::doubtful,
        percent(pairs.bad) + " of " + std::to_string(pairs.pairs) +
            " pairs of scans taken right after each other contradict each other where the path puts them: the one saw "
            "through what the other saw"};
}

/// Healthy logs stay below 10 % even with people, doors and chairs in between. Where a loop did not close, or the map
/// stalled, a fifth and more of the pairs disagree; where nearly half of them do, there is no map.
Found revisits_disagree(const Evidence& evidence) {
    constexpr double doubtful_share = 0.15;
    constexpr double refuted_share = 0.4;
    const PairEvidence& pairs = evidence.revisits;
    if (pairs.pairs < fewest_pairs || pairs.bad <= doubtful_share) {
        return std::nullopt;
    }
    return Finding{pairs.bad > refuted_share ? Standing::refuted : Standing::doubtful,
                   percent(pairs.bad) + " of " + std::to_string(pairs.pairs) +
                       " pairs of scans taken at the same place at different times contradict each other: walls are in "
                       "the map twice, or where there is free space"};
}

/// The regressions below need some motion, or a standing robot's noise would decide.
constexpr double least_way_m = 5.0;
constexpr double least_turning_rad = std::numbers::pi;

/// Wheels are off by a few per cent, worn or slipping ones included; a tenth is a wrong unit, a wrong scale of the
/// ranges, or matching that held the robot back or drove it on.
Found lengths_differ(const Evidence& evidence) {
    constexpr double most = 0.1;
    const MotionEvidence& motion = evidence.motion;
    const double length_m = std::hypot(motion.along, motion.across);  // whatever its direction: that is another rule
    if (motion.odometry_m < least_way_m || std::abs(length_m - 1.0) <= most) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "for each metre of odometry the scans moved the robot by " + metres(length_m) +
                                           " (over " + fixed_text(motion.odometry_m, 0) + " m)"};
}

/// As for lengths. Turns are measured less well by wheels alone, so that the bound is wider.
Found turns_differ(const Evidence& evidence) {
    constexpr double most = 0.15;
    const MotionEvidence& motion = evidence.motion;
    if (motion.odometry_turn_rad < least_turning_rad || std::abs(motion.turn - 1.0) <= most) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "for each degree that the odometry turned the scans turned the robot by " +
                                           fixed_text(motion.turn, 2) + " degrees" +
                                           (motion.turn < 0.0 ? ", the other way round" : "")};
}

/// A wheeled robot drives where it faces. Three degrees are more than a laser is mounted askew by accident.
Found drives_askew(const Evidence& evidence) {
    constexpr double most = 0.05;
    const MotionEvidence& motion = evidence.motion;
    if (motion.odometry_m < least_way_m || std::abs(motion.across) <= most) {
        return std::nullopt;
    }
    const double degrees = std::atan2(motion.across, motion.along) * 180.0 / std::numbers::pi;
    return Finding{Standing::doubtful, "by the scans the robot drives " + fixed_text(std::abs(degrees), 0) +
                                           " degrees to the " + (degrees > 0.0 ? "left" : "right") +
                                           " of where the odometry says: the laser's direction on the robot may be "
                                           "wrong (--laser-pose)"};
}

/// Where the odometry turns in place, the robot's origin should stay. A robot whose origin is not between its wheels
/// may turn about a point some centimetres away.
Found turns_about_another_point(const Evidence& evidence) {
    constexpr double most_m = 0.3;
    const MotionEvidence& motion = evidence.motion;
    const double away_m = std::hypot(motion.lever_m.x_m, motion.lever_m.y_m);
    if (motion.odometry_turn_rad < least_turning_rad || away_m <= most_m) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "by the scans the robot turns about a point " + metres(away_m) +
                                           " from its origin (x " + metres(motion.lever_m.x_m) + ", y " +
                                           metres(motion.lever_m.y_m) +
                                           "): the laser's place on the robot may be wrong (--laser-pose)"};
}

/// A path that trembles about the odometry's is longer than it. Good maps from the noisiest lidars stay within a
/// twentieth.
Found path_trembles(const Evidence& evidence) {
    constexpr double most = 0.12;
    const MotionEvidence& motion = evidence.motion;
    if (motion.odometry_m < least_way_m) {
        return std::nullopt;
    }
    const double ratio = motion.matched_m / motion.odometry_m;
    if (ratio - std::hypot(motion.along, motion.across) <= most) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "the matched poses tremble: they add up to " + metres(ratio) +
                                           " for each metre of odometry, although they go only " +
                                           metres(motion.along) + " forwards"};
}

/// Slips and bumps give a jump here and there; one update in a hundred is more than that.
Found jumps(const Evidence& evidence) {
    constexpr std::uint64_t few = 3;
    constexpr double most_share = 0.01;
    const MotionEvidence& motion = evidence.motion;
    if (motion.jumps <= few || static_cast<double>(motion.jumps) <= most_share * static_cast<double>(motion.updates)) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "at " + std::to_string(motion.jumps) + " of " + std::to_string(motion.updates) +
                                           " updates the match left the odometry by more than wheels err, by up to " +
                                           metres(motion.worst_jump_m)};
}

/// Where the scans do not tell how far the robot came, only the odometry does. A path that nevertheless departs from it
/// by more than poor wheels err (5 % and half a metre) has no ground. Differences of single updates are to be expected,
/// too: the filter draws motions around the odometry's. Where they are independent of each other, they add up with the
/// root of the number of updates. The usual difference, a median of lengths in the plane, is 1.18 standard deviations
/// of each axis, so that twice the sum of usual ones is 2.4 standard deviations.
Found departs_without_ground(const Evidence& evidence) {
    constexpr double more_m = 0.5;
    constexpr double usual_sums = 2.0;
    const MotionEvidence::Open& open = evidence.motion.open;
    const double usual_sum_m = evidence.motion.usual_m * std::sqrt(static_cast<double>(open.worst_updates));
    if (open.worst_stretch_m <=
        more_m + MotionEvidence::wheels_share * open.worst_length_m + usual_sums * usual_sum_m) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful,
                   "where the scans leave open how far the robot came, the path departs from the "
                   "odometry by " +
                       metres(open.worst_stretch_m) + ", " + metres(open.worst_length_m) + " after they last told it"};
}

/// The same at a single update. Wheels slip by centimetres; half a metre, and twenty times what the two usually differ
/// by, is a match that slid along a wall.
Found leaps_without_ground(const Evidence& evidence) {
    constexpr double most_m = 0.45;
    constexpr double most_ratio = 20.0;
    const MotionEvidence& motion = evidence.motion;
    if (motion.open.worst_step_m <= most_m || motion.open.worst_step_m <= most_ratio * motion.usual_m) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful,
                   "where the scans leave open how far the robot came, the path left the odometry by " +
                       metres(motion.open.worst_step_m) + " at a single update; usually they differ by " +
                       fixed_text(motion.usual_m, 3) + " m"};
}

/// The same for the heading, where the scans see hardly anything. Poor wheels err by 0.008 rad for the root of each
/// metre and drift by 0.0008 rad/s; the bounds are
/// several times that, because a landmark that comes into sight may put the heading right at once.
Found turns_without_ground(const Evidence& evidence) {
    constexpr double more_rad = 0.3;
    constexpr double most_rad_per_m = 0.01;
    const MotionEvidence::Open& open = evidence.motion.open;
    if (open.worst_blind_turn_rad <= more_rad + most_rad_per_m * open.worst_blind_m) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful,
                   "where the scans see hardly anything, the path turns away from the odometry by " +
                       fixed_text(open.worst_blind_turn_rad * 180.0 / std::numbers::pi, 0) + " degrees within " +
                       metres(open.worst_blind_m)};
}

/// A tenth of the scans fits nothing that was mapped before.
Found scans_do_not_fit(const Evidence& evidence) {
    constexpr std::uint64_t few = 5;
    constexpr double most_share = 0.1;
    const MotionEvidence& motion = evidence.motion;
    if (motion.unmatched <= few ||
        static_cast<double>(motion.unmatched) <= most_share * static_cast<double>(motion.updates)) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, std::to_string(motion.unmatched) + " of " + std::to_string(motion.updates) +
                                           " scans fit the map nowhere near the robot"};
}

/// A scan that fits half as well as usual has lost most of what it is matched with. Where that happens at one update,
/// the next finds the map again: good runs of logs whose scans pause in a turn have such an update. Two of them in a
/// row, while the robot comes farther than a match searches, leave the odometry alone to join the two parts of the map.
/// Where some particle fits well, it is the one that survives.
Found torn_at_a_seam(const Evidence& evidence) {
    const MotionEvidence::Seam& seam = evidence.motion.seam;
    if (seam.score >= seam.least_score * evidence.motion.usual_score ||
        seam.best_particle >= seam.least_best_particle * evidence.motion.usual_score) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful,
                   fixed_text(seam.s, 0) +
                       " s after the first scan, two scans in a row fit the map with scores of at most " +
                       fixed_text(seam.score, 2) + ", where " + fixed_text(evidence.motion.usual_score, 2) +
                       " is usual, while the robot moved by " + metres(seam.moved_m) + " and turned by " +
                       fixed_text(seam.turned_rad * 180.0 / std::numbers::pi, 0) +
                       " degrees: what was mapped before may lie askew to what was mapped after"};
}

/// Starting from a stop may look like a stair once in a while.
Found odometry_in_stairs(const Evidence& evidence) {
    constexpr std::uint64_t few = 5;
    constexpr double most_share = 0.3;
    const StepEvidence& steps = evidence.steps;
    if (steps.stairs <= few || static_cast<double>(steps.stairs) <= most_share * static_cast<double>(steps.moving)) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "the odometry stands still and then leaps, " + std::to_string(steps.stairs) +
                                           " times: it is held, or stamped too coarsely, so that the poses between are "
                                           "wrong"};
}

/// On open ground many scans see nothing; where hardly any sees something, there is no map. A few blind scans of a
/// short log say nothing yet, unless all are blind.
Found scans_see_nothing(const Evidence& evidence) {
    constexpr std::size_t few = 10;
    constexpr double most_share = 0.95;
    const bool all_are_blind = evidence.blind_scans > 0 && evidence.blind_scans == evidence.all_scans;
    const bool most_are_blind = evidence.blind_scans > few && static_cast<double>(evidence.blind_scans) >
                                                                  most_share * static_cast<double>(evidence.all_scans);
    if (!all_are_blind && !most_are_blind) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, std::to_string(evidence.blind_scans) + " of " +
                                           std::to_string(evidence.all_scans) +
                                           " scans have no beam with a range: the map shows nothing of what the robot "
                                           "passed (--range-max, --height)"};
}

/// No robot that maps with a lidar drives at 50 km/h.
Found odometry_races(const Evidence& evidence) {
    constexpr double most_m_per_s = 15.0;
    const double speed_m_per_s = evidence.steps.usual_m_per_s;
    if (speed_m_per_s <= most_m_per_s) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "the odometry drives at " + fixed_text(speed_m_per_s, 0) +
                                           " m/s: its unit, or that of the stamps, may be another than metres and "
                                           "seconds"};
}

Found motion_lost(const Evidence& evidence) {
    const StepEvidence& steps = evidence.steps;
    if (steps.lost == 0) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "the scans pause " + std::to_string(steps.lost) +
                                           (steps.lost == 1 ? " time" : " times") + " (up to " +
                                           fixed_text(steps.longest_lost_s, 1) +
                                           " s) while the robot drives, and the odometry knows of no motion meanwhile"};
}

/// An odometry that leads back to where it was as often as the path does, with scans that agree there to two
/// decimetres, has hardly drifted. The right path cannot be three times as far from it.
Found leaves_good_odometry(const Evidence& evidence) {
    constexpr std::size_t enough_pairs = 40;
    constexpr double closed = 0.2;
    constexpr double most_m = 0.6;
    constexpr double least_of_revisits = 0.9;
    const PairEvidence& pairs = evidence.odometry_revisits;
    const auto revisits = static_cast<double>(evidence.revisits.pairs);
    if (pairs.pairs < enough_pairs || static_cast<double>(pairs.pairs) < least_of_revisits * revisits ||
        pairs.bad > closed || evidence.from_odometry_m <= most_m) {
        return std::nullopt;
    }
    return Finding{Standing::doubtful, "the odometry alone leads back to where it was (" + percent(1.0 - pairs.bad) +
                                           " of " + std::to_string(pairs.pairs) +
                                           " pairs of scans agree), but the path is " +
                                           metres(evidence.from_odometry_m) + " away from it"};
}

}  // namespace

std::string name_of(Standing standing) {
    switch (standing) {
        case Standing::plausible:
            return "plausible";
        case Standing::doubtful:
            return "doubtful";
        default:
            return "refuted";
    }
}

Verdict verdict_of(const Evidence& evidence) {
    Verdict verdict;
    for (const auto& rule :
         {neighbours_disagree, revisits_disagree, lengths_differ, turns_differ, drives_askew, turns_about_another_point,
          path_trembles, jumps, departs_without_ground, leaps_without_ground, turns_without_ground, scans_do_not_fit,
          torn_at_a_seam, odometry_in_stairs, motion_lost, scans_see_nothing, odometry_races, leaves_good_odometry}) {
        if (const Found found = rule(evidence)) {
            verdict.standing = std::max(verdict.standing, found->standing);
            verdict.reasons.push_back(found->reason);
        }
    }
    return verdict;
}

Json self_check_json(const Verdict& verdict, const Evidence& evidence) {
    return {
        {"verdict", name_of(verdict.standing)}, {"reasons", verdict.reasons}, {"evidence", evidence_json(evidence)}};
}

}  // namespace ddtool::check

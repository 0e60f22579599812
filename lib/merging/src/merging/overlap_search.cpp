#include "merging/overlap_search.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "ddtool/base/error.hpp"
#include "localization/lost_watch.hpp"

namespace ddtool::merging {
namespace {

/// So many windows are compared, and of these so many looked for in all of the first map; each proposes so many places
/// at most. More would cost memory and time, and a few that agree are enough.
constexpr std::size_t most_compared = 80;
constexpr std::size_t most_searched = 40;
constexpr std::size_t most_places_each = 30;
constexpr std::size_t most_followed = 12;
/// How far the two maps may be bent against each other: on the spot, and for each metre of way.
constexpr double bent_m = 0.1;
constexpr double bent_per_m = 0.02;
constexpr double turned_rad = 0.03;
constexpr double turned_rad_per_m = 0.003;
constexpr double most_deviations = 3.0;
/// Proposals that put a window nearer to each other than this are the same.
constexpr double same_place_m = 0.5;
constexpr double same_turn_rad = 0.2;
/// A window with fewer walls in ground known to both says nothing: 2.5 m of wall, counted both ways.
constexpr std::size_t least_known = 100;
/// Of the walls of one place, seen twice, at least so many agree, where something may have been moved; where fewer than
/// the lower share do, the place is another one.
constexpr double agreed_share = 0.8;
constexpr double contradicted_share = 0.7;
/// Farther than this from a window that agrees, a contradiction may be due to the bend alone.
constexpr double surely_reached_m = 15.0;
/// What the result needs: so many windows that agree, over so much way, and so many for each that shows the same ground
/// and does not agree.
constexpr std::size_t least_agreeing = 3;
constexpr double least_way_m = 6.0;
constexpr std::size_t agreeing_for_each_other = 4;
/// A rival with this share of the evidence is one that must be ruled out by contradictions.
constexpr double rival_share = 0.5;
/// Two windows that share no scan.
constexpr double separate_m = 6.0;

std::vector<std::size_t> spread_over(std::size_t count, std::size_t most) {
    std::vector<std::size_t> chosen;
    const std::size_t wanted = std::min(count, most);
    for (std::size_t i = 0; i < wanted; ++i) {
        chosen.push_back(i * count / wanted);
    }
    return chosen;
}

bool same(const Pose2& a, const Pose2& b) {
    return distance_m(a, b) < same_place_m && std::abs(wrap_angle(a.theta_rad - b.theta_rad)) < same_turn_rad;
}

/// The shares that agree at the right place and at a wrong one are those of a scan.
double evidence_of(const WallAgreement& walls) {
    const double for_one = std::log(localization::usual_support / localization::support_by_chance);
    const double against_one = std::log((1.0 - localization::support_by_chance) / (1.0 - localization::usual_support));
    return for_one * static_cast<double>(walls.agreed) - against_one * static_cast<double>(walls.contradicted());
}

/// Whether a window contradicts one placement more than another, beyond what counting leaves to chance.
bool contradicts_more(const WallAgreement& one, const WallAgreement& other) {
    constexpr double deviations = 3.0;
    constexpr double least = 20.0;  // half a metre of wall, counted both ways
    const auto of_one = static_cast<double>(one.contradicted());
    const auto of_other = static_cast<double>(other.contradicted());
    return of_one - of_other > std::max(least, deviations * std::sqrt(of_one + of_other));
}

}  // namespace

std::size_t Placement::count(Verdict verdict) const {
    return static_cast<std::size_t>(std::ranges::count(windows, verdict, &PlacedWindow::verdict));
}

OverlapSearch::OverlapSearch(const OccupancyGrid& first_grid, const MapSide& second, const RbpfSettings& settings)
    : first_grid_(first_grid),
      second_(second),
      compared_(spread_over(second.windows().size(), most_compared)),
      search_(first_grid, settings.matcher),
      matcher_(settings.matcher, settings.grid.cell_size_m) {
    for (const std::size_t window : compared_) {
        local_maps_.push_back(second.local_map(window));
    }
}

double OverlapSearch::way_between_m(std::size_t a, std::size_t b) const {
    return std::abs(second_.windows()[compared_[a]].way_m - second_.windows()[compared_[b]].way_m);
}

/// The transforms that most windows vote for, the best first, each once.
std::vector<OverlapSearch::Proposal> OverlapSearch::proposals() {
    std::vector<Proposal> all;
    for (const std::size_t window : spread_over(compared_.size(), most_searched)) {
        const localization::FoundPlaces found = search_.search(local_maps_[window]->points);
        for (std::size_t place = 0; place < std::min(found.places.size(), most_places_each); ++place) {
            all.push_back({.window = window, .pose = found.places[place].pose});
        }
    }
    for (Proposal& proposal : all) {
        const Pose2 transform = proposal.pose * inverse(second_.anchor(compared_[proposal.window]));
        std::vector<bool> voted(compared_.size(), false);
        for (const Proposal& other : all) {
            const Pose2 expected = transform * second_.anchor(compared_[other.window]);
            const double way_m = way_between_m(proposal.window, other.window);
            if (!voted[other.window] &&
                distance_m(expected, other.pose) < most_deviations * (bent_m + bent_per_m * way_m) &&
                std::abs(wrap_angle(expected.theta_rad - other.pose.theta_rad)) <
                    most_deviations * (turned_rad + turned_rad_per_m * way_m)) {
                voted[other.window] = true;
                ++proposal.votes;
            }
        }
    }
    std::ranges::stable_sort(all, [](const Proposal& a, const Proposal& b) { return a.votes > b.votes; });
    std::vector<Proposal> best;
    for (const Proposal& proposal : all) {
        const Pose2 transform = proposal.pose * inverse(second_.anchor(compared_[proposal.window]));
        const bool is_new = std::ranges::none_of(best, [&](const Proposal& other) {
            return same(transform * second_.anchor(compared_[other.window]), other.pose);
        });
        if (is_new && best.size() < most_followed) {
            best.push_back(proposal);
        }
    }
    return best;
}

/// \param way_m driven since the nearest window that agrees, from which `expected` follows
PlacedWindow OverlapSearch::placed(std::size_t window, const Pose2& expected, double way_m) {
    const graph::StretchMap& local_map = *local_maps_[window];
    const double sd_m = bent_m + bent_per_m * way_m;
    const double sd_rad = turned_rad + turned_rad_per_m * way_m;
    const ScanMatch match = matcher_.match(first_grid_, local_map.match_points, expected,
                                           {.sigma_along_m = sd_m, .sigma_across_m = sd_m, .sigma_turn_rad = sd_rad});
    const bool is_near = match.accepted() && distance_m(match.pose, expected) < most_deviations * sd_m &&
                         std::abs(wrap_angle(match.pose.theta_rad - expected.theta_rad)) < most_deviations * sd_rad;
    PlacedWindow result{.pose = is_near ? match.pose : expected, .walls = {}};
    result.walls = wall_agreement(local_map, first_grid_, result.pose);
    if (result.walls.known >= least_known) {
        const double share = result.walls.share();
        result.verdict = is_near && share >= agreed_share                         ? Verdict::agrees
                         : share < contradicted_share && way_m < surely_reached_m ? Verdict::contradicts
                         : way_m < surely_reached_m                               ? Verdict::unclear
                                                                                  : Verdict::apart;
    }
    return result;
}

/// Follows a proposal from its window along the path in both directions. Each window is expected where the nearest one
/// that agrees puts it.
Placement OverlapSearch::followed(const Proposal& proposal) {
    Placement placement{.windows = std::vector<PlacedWindow>(compared_.size())};
    const PlacedWindow seed = placed(proposal.window, proposal.pose, 0.0);
    placement.windows[proposal.window] = seed;
    const auto follow = [&](std::size_t from, std::size_t window) {
        const Pose2 expected =
            placement.windows[from].pose * between(second_.anchor(compared_[from]), second_.anchor(compared_[window]));
        placement.windows[window] = placed(window, expected, way_between_m(from, window));
        return placement.windows[window].verdict == Verdict::agrees ? window : from;
    };
    std::size_t last = proposal.window;
    for (std::size_t window = proposal.window + 1; window < compared_.size(); ++window) {
        last = follow(last, window);
    }
    last = proposal.window;
    for (std::size_t window = proposal.window; window-- > 0;) {
        last = follow(last, window);
    }
    for (const PlacedWindow& window : placement.windows) {
        if (window.verdict != Verdict::apart) {
            placement.evidence += evidence_of(window.walls);
        }
    }
    return placement;
}

/// A rival is ruled out if it contradicts the first map in two separate places where the best does not: what was moved
/// between the drives is one place. Or if it has little in common with the first map at all.
bool OverlapSearch::is_ruled_out(const Placement& rival, const Placement& best) const {
    if (rival.evidence < rival_share * best.evidence) {
        return true;
    }
    std::optional<std::size_t> before;
    for (std::size_t window = 0; window < compared_.size(); ++window) {
        if (rival.windows[window].verdict == Verdict::apart || best.windows[window].verdict == Verdict::apart ||
            !contradicts_more(rival.windows[window].walls, best.windows[window].walls)) {
            continue;
        }
        if (before && way_between_m(*before, window) >= separate_m) {
            return true;
        }
        before = before ? before : window;
    }
    return false;
}

Placement OverlapSearch::find() {
    std::vector<Placement> placements;
    for (const Proposal& proposal : proposals()) {
        placements.push_back(followed(proposal));
    }
    std::ranges::stable_sort(placements,
                             [](const Placement& a, const Placement& b) { return a.evidence > b.evidence; });
    if (placements.empty() || placements.front().count(Verdict::agrees) == 0) {
        throw Error("they have no overlap that was found");
    }
    const Placement& best = placements.front();
    const std::size_t agreeing = best.count(Verdict::agrees);
    std::vector<std::size_t> where;
    for (std::size_t window = 0; window < compared_.size(); ++window) {
        if (best.windows[window].verdict == Verdict::agrees) {
            where.push_back(window);
        }
    }
    if (agreeing < least_agreeing || way_between_m(where.front(), where.back()) < least_way_m) {
        throw Error("they have no overlap of which one can be sure: only " + std::to_string(agreeing) + " of " +
                    std::to_string(compared_.size()) + " windows of the second agree with the first");
    }
    const std::size_t others = best.count(Verdict::contradicts) + best.count(Verdict::unclear);
    if (agreeing < agreeing_for_each_other * others) {
        throw Error("they contradict each other where they would overlap: the walls differ in " +
                    std::to_string(others) + " windows of the second, and agree in " + std::to_string(agreeing));
    }
    for (const Placement& rival : placements) {
        const bool is_same = std::ranges::any_of(
            where, [&](std::size_t window) { return same(rival.windows[window].pose, best.windows[window].pose); });
        if (!is_same && !is_ruled_out(rival, best)) {
            throw Error("the second fits into the first at more than one place");
        }
    }
    return best;
}

}  // namespace ddtool::merging

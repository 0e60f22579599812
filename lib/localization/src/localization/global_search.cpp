#include "localization/global_search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "ddtool/filter/information_fusion.hpp"
#include "filter/pose_covariance.hpp"

namespace ddtool::localization {
namespace {

/// What a point in ground that was never observed counts, of CoarseMap::on_wall. Less than a wall, so that a place half
/// outside of the map does not look better than one inside.
constexpr std::uint8_t unknown_value = 25;
constexpr std::size_t most_points = 90;
/// Places whose coarse score is below this share of the best are not looked at any further: what the lattice and the
/// fading of the walls leave to chance.
constexpr double least_share = 0.85;
/// A scan that fits nowhere better than this fits nowhere.
constexpr double least_score = 0.4;
constexpr std::size_t most_visits = 600'000;
constexpr std::size_t most_places = 300;
/// Coarse places nearer than this are the same.
constexpr double same_place_m = 0.4;
constexpr double same_turn_rad = 0.25;
/// Refined places nearer than this are the same.
constexpr double refined_m = 0.1;
constexpr double refined_rad = 0.05;
/// A place that explains this much less of the scan than the best one is none.
constexpr double least_support_below_best = 0.2;
/// How sure a place of the lattice is.
constexpr PosePrior place_prior{.sigma_along_m = 0.25, .sigma_across_m = 0.25, .sigma_turn_rad = 0.06};

/// Turns by which the middle of the points moves by about a cell.
std::size_t turns_for(const std::vector<Point2>& points, double cell_m) {
    const double step_rad = std::clamp(1.5 * cell_m / graph::mean_distance_m(points), 0.015, 0.06);
    return static_cast<std::size_t>(std::ceil(2.0 * std::numbers::pi / step_rad));
}

bool same(const Pose2& a, const Pose2& b, double apart_m, double turned_rad) {
    return distance_m(a, b) < apart_m && std::abs(wrap_angle(a.theta_rad - b.theta_rad)) < turned_rad;
}

}  // namespace

GlobalSearch::GlobalSearch(const OccupancyGrid& map, const ScanMatcherSettings& matcher)
    : map_(map), matcher_(matcher, map.cell_size_m()) {}

/// Made at the first search, since most runs with a given start need none.
void GlobalSearch::make_levels() {
    coarse_.emplace(map_);
    constexpr int margin = 1 << (levels - 1);
    width_ = coarse_->width() + margin;
    height_ = coarse_->height() + margin;
    const auto at = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
    };
    std::vector<std::uint8_t> finest(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_),
                                     unknown_value);
    for (int y = 0; y < coarse_->height(); ++y) {
        for (int x = 0; x < coarse_->width(); ++x) {
            const std::uint8_t value = coarse_->cell(x, y);
            finest[at(x + margin, y + margin)] = value == graph::CoarseMap::unknown ? unknown_value : value;
        }
    }
    levels_.push_back(std::move(finest));
    for (int level = 1; level < levels; ++level) {
        const int half = 1 << (level - 1);
        std::vector<std::uint8_t> wider = levels_.back();
        for (int y = 0; y < height_; ++y) {
            for (int x = 0; x < width_; ++x) {
                const std::vector<std::uint8_t>& below = levels_.back();
                const int right = std::min(x + half, width_ - 1);
                const int above = std::min(y + half, height_ - 1);
                wider[at(x, y)] = std::max(std::max(below[at(x, y)], below[at(right, y)]),
                                           std::max(below[at(x, above)], below[at(right, above)]));
            }
        }
        levels_.push_back(std::move(wider));
    }
}

std::uint8_t GlobalSearch::value(int level, int x, int y) const {
    constexpr int margin = 1 << (levels - 1);
    x += margin;
    y += margin;
    if (x < 0 || y < 0 || x >= width_ || y >= height_) {
        return unknown_value;
    }
    return levels_[static_cast<std::size_t>(level)]
                  [static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
}

double GlobalSearch::score(const Offsets& offsets, int level, int x, int y) const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < offsets.x.size(); ++i) {
        sum += value(level, x + offsets.x[i], y + offsets.y[i]);
    }
    return static_cast<double>(sum) / (static_cast<double>(offsets.x.size()) * graph::CoarseMap::on_wall);
}

/// Whether the robot may be in a block: it stands on ground that was observed.
bool GlobalSearch::observed_in(int level, int x, int y) const {
    const int size = 1 << level;
    for (int v = y; v < y + size; ++v) {
        for (int u = x; u < x + size; ++u) {
            if (coarse_->cell(u, v) != graph::CoarseMap::unknown) {
                return true;
            }
        }
    }
    return false;
}

/// The places of the lattice that score about as much as the best one, the best first, one in each neighbourhood.
std::vector<GlobalSearch::Block> GlobalSearch::coarse_places(const std::vector<Offsets>& turns, bool& complete) const {
    const auto lower = [](const Block& a, const Block& b) { return a.bound < b.bound; };
    std::priority_queue<Block, std::vector<Block>, decltype(lower)> open(lower);
    double least = least_score;
    const auto consider = [&](int level, int turn, int x, int y) {
        const double bound = score(turns[static_cast<std::size_t>(turn)], level, x, y);
        if (bound >= least) {
            open.push({bound, level, turn, x, y});
        }
    };
    constexpr int top = levels - 1;
    for (int y = 0; y < coarse_->height(); y += 1 << top) {
        for (int x = 0; x < coarse_->width(); x += 1 << top) {
            if (observed_in(top, x, y)) {
                for (std::size_t turn = 0; turn < turns.size(); ++turn) {
                    consider(top, static_cast<int>(turn), x, y);
                }
            }
        }
    }
    std::vector<Block> places;
    std::size_t visits = 0;
    while (!open.empty() && open.top().bound >= least) {
        const Block block = open.top();
        open.pop();
        if (block.level == 0) {
            least = std::max(least, least_share * block.bound);  // the first one has the highest score of all
            const Pose2 pose = pose_of(block, turns.size());
            if (std::ranges::none_of(places, [&](const Block& place) {
                    return same(pose, pose_of(place, turns.size()), same_place_m, same_turn_rad);
                })) {
                places.push_back(block);
            }
        } else {
            const int half = 1 << (block.level - 1);
            for (const auto& [x, y] : {std::pair{block.x, block.y},
                                       {block.x + half, block.y},
                                       {block.x, block.y + half},
                                       {block.x + half, block.y + half}}) {
                if (observed_in(block.level - 1, x, y)) {
                    consider(block.level - 1, block.turn, x, y);
                }
            }
        }
        if (places.size() == most_places || ++visits == most_visits) {
            complete = false;
            break;
        }
    }
    return places;
}

Pose2 GlobalSearch::pose_of(const Block& block, std::size_t turns) const {
    const double turn_rad = 2.0 * std::numbers::pi / static_cast<double>(turns);
    return {coarse_->corner_m().x_m + (block.x + 0.5) * coarse_->cell_m(),
            coarse_->corner_m().y_m + (block.y + 0.5) * coarse_->cell_m(), wrap_angle(block.turn * turn_rad)};
}

void GlobalSearch::refine(const ScanPoints& points, FoundPlaces& found, const std::vector<Pose2>& starts) {
    const MatchPoints match_points(points, map_.cell_size_m());
    for (const Pose2& start : starts) {
        const ScanMatch match = matcher_.match(map_, match_points, start, place_prior);
        if (!match.accepted() || std::ranges::any_of(found.places, [&](const FoundPlace& place) {
                return same(place.pose, match.pose, refined_m, refined_rad);
            })) {
            continue;
        }
        const Eigen::Matrix3d prior = information_of(place_prior, match.pose.theta_rad);
        const Eigen::Matrix3d held =
            credible_information(match.information, prior, InformationFusion::normal_error_rad, 0.0);
        found.places.push_back({.pose = match.pose,
                                .covariance = (prior + held).inverse(),
                                .log_likelihood = match.log_likelihood,
                                .fit = scan_fit(points, map_, match.pose)});
    }
    if (found.places.empty()) {
        return;
    }
    std::ranges::stable_sort(
        found.places, [](const FoundPlace& a, const FoundPlace& b) { return a.fit.support() > b.fit.support(); });
    const double least = found.places.front().fit.support() - least_support_below_best;
    std::erase_if(found.places, [&](const FoundPlace& place) { return place.fit.support() < least; });
}

FoundPlaces GlobalSearch::search(const ScanPoints& points) {
    FoundPlaces found;
    const std::vector<Point2> some = graph::every_point(points, points.size() / most_points + 1);
    if (some.empty() || map_.observed_box().empty()) {
        return found;
    }
    if (!coarse_) {
        make_levels();
    }
    std::vector<Offsets> turns(turns_for(some, coarse_->cell_m()));
    for (std::size_t turn = 0; turn < turns.size(); ++turn) {
        const Pose2 turned{0.0, 0.0,
                           2.0 * std::numbers::pi * static_cast<double>(turn) / static_cast<double>(turns.size())};
        for (const Point2& point : some) {
            const Point2 at = turned * point;
            // of a robot in the middle of a cell
            turns[turn].x.push_back(static_cast<int>(std::floor(at.x_m / coarse_->cell_m() + 0.5)));
            turns[turn].y.push_back(static_cast<int>(std::floor(at.y_m / coarse_->cell_m() + 0.5)));
        }
    }
    std::vector<Pose2> starts;
    for (const Block& block : coarse_places(turns, found.complete)) {
        starts.push_back(pose_of(block, turns.size()));
    }
    refine(points, found, starts);
    return found;
}

}  // namespace ddtool::localization

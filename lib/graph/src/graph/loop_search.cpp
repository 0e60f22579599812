#include "graph/loop_search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/squared.hpp"
#include "ddtool/filter/information_fusion.hpp"
#include "filter/pose_covariance.hpp"
#include "graph/clear_fall.hpp"
#include "graph/coarse_map.hpp"

namespace ddtool::graph {
namespace {

/// A point lies on a wall of the other map if it is this near to an occupied point: the field's reach less the noise of
/// both maps.
constexpr double on_wall_m = 0.1;
/// Two maps of one place, made with the same lidar, disagree only where something moved and at their edges.
constexpr double least_agreed = 0.8;
/// The shares of both maps that the other observed: the larger and the smaller of them.
constexpr double least_known = 0.5;
constexpr double least_known_of_other = 0.25;
/// Of the way of one of the stretches so much leads over ground that the other one saw free: else the two maps lie on
/// different sides of one wall.
constexpr double least_free = 0.5;
/// The fit is tried again so far to either side along the direction that it holds least.
constexpr double peak_half_width_m = 0.15;
/// Maps with fewer points in common, a few trees or a metre of wall, are alike by chance.
constexpr std::size_t least_points = 100;
/// Places nearer than this to each other are the same peak.
constexpr double same_place_m = 0.5;
constexpr double same_heading_rad = 0.2;
/// Deviations of the prediction that the search reaches to, and beyond which a match is not believed.
constexpr double gate_deviations = 3.5;
constexpr double most_half_m = 10.0;
constexpr double most_half_rad = 0.8;
/// What the matching of two maps of 5 cm cells leaves at best, whatever the number of points says.
constexpr double least_sd_m = 0.01;
constexpr double least_sd_rad = 0.002;

constexpr double lattice_m = 0.2;
constexpr std::size_t coarse_points = 120;
constexpr std::size_t most_places = 8;

/// The mean value of the points in observed ground, 0..1; 0 where too few are.
double coarse_score(const CoarseMap& map, const std::vector<Point2>& turned, double x_m, double y_m) {
    std::size_t known = 0;
    std::size_t sum = 0;
    for (const Point2& point : turned) {
        const std::uint8_t value = map.value(point.x_m + x_m, point.y_m + y_m);
        if (value != CoarseMap::unknown) {
            ++known;
            sum += value;
        }
    }
    if (static_cast<double>(known) < least_known_of_other * static_cast<double>(turned.size()) || known == 0) {
        return 0.0;
    }
    return static_cast<double>(sum) / (static_cast<double>(known) * CoarseMap::on_wall);
}

bool same_place(const Pose2& a, const Pose2& b) {
    return distance_m(a, b) < same_place_m && std::abs(wrap_angle(a.theta_rad - b.theta_rad)) < same_heading_rad;
}

/// The information that is left when the pose along `direction` is anything.
Eigen::Matrix3d without_direction(const Eigen::Matrix3d& information, const Eigen::Vector3d& direction) {
    const Eigen::Vector3d image = information * direction;
    const double held = direction.dot(image);
    return held > 0.0 ? Eigen::Matrix3d(information - image * image.transpose() / held) : information;
}

/// (I^-1 + floor)^-1, where a direction without information stays without.
Eigen::Matrix3d no_better_than_maps(const Eigen::Matrix3d& information) {
    const Eigen::Vector3d floor(1.0 / squared(least_sd_m), 1.0 / squared(least_sd_m), 1.0 / squared(least_sd_rad));
    const Eigen::Matrix3d floor_information = floor.asDiagonal();
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d> axes(information, floor_information);
    Eigen::Vector3d ratios;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const double ratio = axes.eigenvalues()(i) < 1e-6 ? 0.0 : axes.eigenvalues()(i);
        ratios(i) = ratio / (1.0 + ratio);
    }
    const Eigen::Matrix3d basis = floor_information * axes.eigenvectors();
    return basis * ratios.asDiagonal() * basis.transpose();
}

double share_of(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

Cell cell_under(const OccupancyGrid& grid, const Point2& point) {
    const double cell_m = grid.cell_size_m();
    return {static_cast<int>(std::floor(point.x_m / cell_m)), static_cast<int>(std::floor(point.y_m / cell_m))};
}

/// The share of the way of one stretch that leads over ground which the other one saw free.
double free_share(const StretchMap& from, const OccupancyGrid& in, const Pose2& in_from_other) {
    const auto is_free = [&](const Point2& place) {
        const std::int8_t odds = in.log_odds(cell_under(in, in_from_other * place));
        return odds != Patch::unknown && odds < 0;
    };
    return share_of(static_cast<std::size_t>(std::count_if(from.way.begin(), from.way.end(), is_free)),
                    from.way.size());
}

struct Fit {
    Pose2 pose;
    Eigen::Matrix3d information;
    double agreed = 0.0;
    double known = 0.0;            ///< points of both maps that the other observed
    double contradicted = 0.0;     ///< of those, the ones that do not lie on the other's walls
    double from_prediction = 0.0;  ///< squared, in units of the covariance
    double likelihood = 0.0;       ///< log, of the newer map's points in the older map
    bool on_one_side = true;       ///< the stretches see the same side of the walls
};

/// Whether a fit's contradictions are no more than those of the best by what counting leaves to chance.
bool fits_as_well(const Fit& fit, const Fit& best) {
    constexpr double deviations = 3.0;
    constexpr double least_overlap = 0.75;  // a place with much less in common is not compared with the same walls
    return fit.known >= least_overlap * best.known && fit.likelihood >= best.likelihood - clear_fall &&
           fit.contradicted <= best.contradicted + deviations * std::sqrt(best.contradicted + 1.0);
}

}  // namespace

Overlap overlap(const StretchMap& from, const OccupancyGrid& in, const Pose2& in_from_other) {
    const double cell_m = in.cell_size_m();
    std::size_t known = 0;
    std::size_t agreed = 0;
    for (std::size_t i = 0; i < from.points.size(); ++i) {
        const Point2 at = in_from_other * Point2{double{from.points.x_m[i]}, double{from.points.y_m[i]}};
        const Cell cell = cell_under(in, at);
        const NearestPoint nearest = in.nearest(cell);
        const bool near =
            !nearest.none() && cell_m * std::hypot(nearest.x, nearest.y) <= on_wall_m * NearestPoint::units_per_cell;
        known += near || in.log_odds(cell) != Patch::unknown ? 1 : 0;
        agreed += near ? 1 : 0;
    }
    return {.points = from.points.size(), .known = known, .agreed = agreed};
}

double Overlap::known_share() const { return share_of(known, points); }

double Overlap::agreed_share() const { return share_of(agreed, known); }

LoopSearch::LoopSearch(const RbpfSettings& settings)
    : settings_(settings), matcher_(settings.matcher, settings.grid.cell_size_m) {}

std::vector<LoopSearch::Place> LoopSearch::coarse_places(const StretchMap& older, const StretchMap& newer,
                                                         const Pose2& predicted, double half_m, double half_rad) const {
    const CoarseMap map(older.grid);
    const std::vector<Point2> points = points_of_each_direction(newer.points, coarse_points);
    const double turn_rad = std::clamp(lattice_m / mean_distance_m(points), 0.01, 0.05);
    const int turns = static_cast<int>(std::ceil(half_rad / turn_rad));
    const int steps = static_cast<int>(std::ceil(half_m / lattice_m));
    std::vector<Place> best(static_cast<std::size_t>(squared(2 * steps + 1)));
    for (int turn = -turns; turn <= turns; ++turn) {
        const double theta_rad = wrap_angle(predicted.theta_rad + turn * turn_rad);
        std::vector<Point2> turned;
        std::transform(points.begin(), points.end(), std::back_inserter(turned), [&](const Point2& point) {
            return Pose2{0.0, 0.0, theta_rad} * point;
        });
        std::size_t place = 0;
        for (int y = -steps; y <= steps; ++y) {
            for (int x = -steps; x <= steps; ++x, ++place) {
                const Pose2 pose{predicted.x_m + x * lattice_m, predicted.y_m + y * lattice_m, theta_rad};
                const double score = coarse_score(map, turned, pose.x_m, pose.y_m);
                if (score > best[place].score) {
                    best[place] = {pose, score};
                }
            }
        }
    }
    std::stable_sort(best.begin(), best.end(), [](const Place& a, const Place& b) { return a.score > b.score; });
    std::vector<Place> peaks;
    for (const Place& place : best) {
        if (peaks.size() == most_places || place.score < 0.7 * best.front().score || place.score <= 0.0) {
            break;
        }
        if (std::none_of(peaks.begin(), peaks.end(),
                         [&](const Place& peak) { return distance_m(peak.pose, place.pose) < same_place_m; })) {
            peaks.push_back(place);
        }
    }
    return peaks;
}

/// Walls that are rough, or that few scans have drawn, seem to hold a map along themselves. So along the direction that
/// is held least, no more is believed than the fall of the likelihood to both sides shows, and nothing if it does not
/// fall.
LoopSearch::Peak LoopSearch::peak_of(const StretchMap& older, const StretchMap& newer, const Pose2& pose,
                                     const Eigen::Matrix3d& information) {
    constexpr double least_information = 1e-3;
    const Eigen::Matrix3d covariance = (information + least_information * Eigen::Matrix3d::Identity()).inverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(covariance.topLeftCorner<2, 2>());
    const Eigen::Vector2d along = axes.eigenvectors().col(1);
    const Eigen::Vector3d shift = peak_half_width_m / axes.eigenvalues()(1) * covariance.leftCols<2>() * along;
    const auto likelihood = [&](const Eigen::Vector3d& by) {
        return matcher_.evaluate(older.grid, newer.match_points, moved_by(pose, by)).log_likelihood;
    };
    const double here = likelihood(Eigen::Vector3d::Zero());
    const double fall = here - std::max(likelihood(shift), likelihood(-shift));
    const Eigen::Matrix3d without = without_direction(information, {along.x(), along.y(), 0.0});
    if (fall < clear_fall) {
        return {without, true};
    }
    const double seen = 2.0 * fall / squared(peak_half_width_m);
    const double share = std::min(1.0, seen * axes.eigenvalues()(1));
    return {without + share * (information - without), false};
}

LoopMatch LoopSearch::match(const StretchMap& older, const StretchMap& newer, const Pose2& predicted,
                            const Eigen::Matrix3d& covariance) {
    const double half_m = std::min(most_half_m, gate_deviations * std::sqrt(covariance.topLeftCorner<2, 2>().trace()));
    const double half_rad = std::min(most_half_rad, gate_deviations * std::sqrt(covariance(2, 2)));
    std::vector<Place> places{{predicted, 0.0}};
    if (half_m > lattice_m) {
        const std::vector<Place> found = coarse_places(older, newer, predicted, half_m, half_rad);
        places.insert(places.end(), found.begin(), found.end());
    }
    const Eigen::Matrix3d gate = covariance.inverse();
    std::vector<Fit> fits;
    LoopMatch result;
    double closest = 0.0;
    for (const Place& place : places) {
        const ScanMatch found = matcher_.match(older.grid, newer.match_points, place.pose,
                                               {.sigma_along_m = 0.3, .sigma_across_m = 0.3, .sigma_turn_rad = 0.1});
        const Overlap forth = overlap(newer, older.grid, found.pose);
        const Overlap back = overlap(older, newer.grid, inverse(found.pose));
        const double agreed = std::min(forth.agreed_share(), back.agreed_share());
        const double more_known = std::max(forth.known_share(), back.known_share());
        const double less_known = std::min(forth.known_share(), back.known_share());
        if (std::min(forth.known, back.known) < least_points || more_known < least_known ||
            less_known < least_known_of_other) {
            continue;
        }
        closest = std::max(closest, agreed);
        const Eigen::Vector3d from_predicted = offset(predicted, found.pose);
        const double from_prediction = from_predicted.dot(gate * from_predicted);
        if (agreed >= least_agreed && from_prediction <= squared(gate_deviations) + 3.0) {
            const std::size_t known = forth.known + back.known;
            fits.push_back({.pose = found.pose,
                            .information = found.information,
                            .agreed = agreed,
                            .known = static_cast<double>(known),
                            .contradicted = static_cast<double>(known - forth.agreed - back.agreed),
                            .from_prediction = from_prediction,
                            .likelihood = found.log_likelihood,
                            .on_one_side = std::max(free_share(newer, older.grid, found.pose),
                                                    free_share(older, newer.grid, inverse(found.pose))) >= least_free});
        }
    }
    if (fits.empty()) {
        result.agreed = closest;
        result.refusal = closest == 0.0            ? "the maps hardly overlap"
                         : closest >= least_agreed ? "the place that fits is farther than the odometry allows"
                                                   : "the maps do not agree";
        return result;
    }
    const Fit best = *std::max_element(fits.begin(), fits.end(),
                                       [](const Fit& a, const Fit& b) { return a.likelihood < b.likelihood; });
    std::erase_if(fits, [&](const Fit& fit) { return !fits_as_well(fit, best); });
    const Fit chosen = *std::min_element(
        fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.from_prediction < b.from_prediction; });
    if (!chosen.on_one_side) {
        result.agreed = chosen.agreed;
        result.refusal = "the maps lie on different sides of a wall";
        return result;
    }
    result.older_from_newer = chosen.pose;
    result.agreed = chosen.agreed;
    Eigen::Matrix3d information =
        credible_information(chosen.information, gate, InformationFusion::normal_error_rad, 0.0);
    Eigen::Matrix2d scatter = Eigen::Matrix2d::Zero();
    for (const Fit& fit : fits) {
        if (!same_place(fit.pose, chosen.pose)) {
            const Eigen::Vector2d apart = offset(chosen.pose, fit.pose).head<2>();
            scatter += apart * apart.transpose();
        }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> rivals(scatter);
    if (rivals.eigenvalues()(0) > squared(same_place_m)) {
        result.refusal = "more than one place fits";
        return result;
    }
    if (scatter.trace() > 0.0) {
        const Eigen::Vector2d along = rivals.eigenvectors().col(1);
        information = without_direction(information, {along.x(), along.y(), 0.0});
        result.open_along = true;
    } else {
        const Peak peak = peak_of(older, newer, chosen.pose, information);
        information = peak.information;
        result.open_along = peak.is_open;
    }
    const Eigen::Matrix3d to_older = turned_about_z(chosen.pose.theta_rad);
    result.information = to_older.transpose() * no_better_than_maps(information) * to_older;
    return result;
}

}  // namespace ddtool::graph

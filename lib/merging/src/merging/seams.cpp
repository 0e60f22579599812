#include "merging/seams.hpp"

#include <Eigen/LU>
#include <algorithm>

#include "base/squared.hpp"
#include "ddtool/filter/information_fusion.hpp"
#include "filter/pose_covariance.hpp"
#include "graph/loop_search.hpp"
#include "localization/scan_fit.hpp"

namespace ddtool::merging {
namespace {

/// Windows whose anchors are at most so far apart see the same walls.
constexpr double nearby_m = 3.0;
/// Each window is tied to so many of the other side, each so far on the way from the others.
constexpr std::size_t most_partners = 2;
constexpr double partners_apart_m = 6.0;

/// Where a scan is about to be matched: some cells about where the windows put it.
constexpr PosePrior scan_prior{.sigma_along_m = 0.1, .sigma_across_m = 0.1, .sigma_turn_rad = 0.03};
/// The map explains so much of a scan that is at its place.
constexpr double least_support = 0.8;
/// What a match of a scan leaves at best, whatever the number of points says: the noise of a map's cells. Neighbouring
/// scans err alike.
constexpr double scan_sd_m = 0.02;
constexpr double scan_sd_rad = 0.005;

/// (I^-1 + floor)^-1, where I may be singular.
Eigen::Matrix3d no_better_than_a_map(const Eigen::Matrix3d& information) {
    constexpr double least = 1e-3;  // so that a direction without information can be inverted
    Eigen::Matrix3d covariance = (information + least * Eigen::Matrix3d::Identity()).inverse();
    covariance.diagonal() += Eigen::Vector3d(squared(scan_sd_m), squared(scan_sd_m), squared(scan_sd_rad));
    return covariance.inverse();
}

std::vector<std::size_t> partners_of(const Pose2& pose, const MapSide& older) {
    std::vector<std::size_t> near;
    for (std::size_t window = 0; window < older.windows().size(); ++window) {
        if (distance_m(older.anchor(window), pose) <= nearby_m) {
            near.push_back(window);
        }
    }
    std::ranges::stable_sort(near, [&](std::size_t a, std::size_t b) {
        return distance_m(older.anchor(a), pose) < distance_m(older.anchor(b), pose);
    });
    std::vector<std::size_t> chosen;
    for (const std::size_t window : near) {
        const bool apart = std::ranges::none_of(chosen, [&](std::size_t other) {
            return std::abs(older.windows()[window].way_m - older.windows()[other].way_m) < partners_apart_m;
        });
        if (apart && chosen.size() < most_partners) {
            chosen.push_back(window);
        }
    }
    return chosen;
}

}  // namespace

std::vector<graph::RelativeEdge> seams(const MapSide& older, const MapSide& newer,
                                       const std::vector<ExpectedWindow>& expected, const RbpfSettings& settings) {
    graph::LoopSearch search(settings);
    std::vector<graph::RelativeEdge> edges;
    for (const ExpectedWindow& window : expected) {
        for (const std::size_t partner : partners_of(window.pose, older)) {
            const graph::LoopMatch match = search.match(*older.local_map(partner), *newer.local_map(window.window),
                                                        between(older.anchor(partner), window.pose), window.covariance);
            if (match.refusal.empty()) {
                edges.push_back({.from = older.windows()[partner].anchor,
                                 .to = newer.windows()[window.window].anchor,
                                 .measured = match.older_from_newer,
                                 .information = match.information});
            }
        }
    }
    return edges;
}

std::vector<graph::RelativeEdge> scan_seams(const OccupancyGrid& older_map, const std::vector<Pose2>& older_poses,
                                            const std::vector<maps::MapNode>& newer,
                                            const std::vector<Pose2>& newer_poses, const RbpfSettings& settings) {
    ScanMatcher matcher(settings.matcher, settings.grid.cell_size_m);
    std::vector<graph::RelativeEdge> edges;
    for (std::size_t node = 0; node < newer.size(); ++node) {
        const Pose2& expected = newer_poses[node];
        const auto nearest =
            std::ranges::min_element(older_poses, {}, [&](const Pose2& pose) { return distance_m(pose, expected); });
        if (nearest == older_poses.end() || distance_m(*nearest, expected) > nearby_m) {
            continue;
        }
        const ScanPoints points = newer[node].scan.points.unpacked();
        const ScanMatch match =
            matcher.match(older_map, MatchPoints(points, settings.grid.cell_size_m), expected, scan_prior);
        if (!match.accepted() || localization::scan_fit(points, older_map, match.pose).support() < least_support) {
            continue;
        }
        const Eigen::Matrix3d prior = information_of(scan_prior, expected.theta_rad);
        const Eigen::Matrix3d held =
            credible_information(match.information, prior, InformationFusion::normal_error_rad, 0.0);
        const Pose2 measured = moved_by(match.pose, offset_without_prior(match, expected, scan_prior));
        const Eigen::Matrix3d to_map = turned_about_z(measured.theta_rad);
        edges.push_back({.from = static_cast<std::size_t>(nearest - older_poses.begin()),
                         .to = node,
                         .measured = between(*nearest, measured),
                         .information = to_map.transpose() * no_better_than_a_map(held) * to_map});
    }
    return edges;
}

}  // namespace ddtool::merging

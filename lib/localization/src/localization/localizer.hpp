#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "localization/global_search.hpp"
#include "localization/lost_watch.hpp"
#include "localization/mode_resampling.hpp"
#include "localization/place_trust.hpp"

namespace ddtool::localization {

/// Where the robot is at the start, if that is known.
struct StartPose {
    Pose2 pose;  ///< map_from_robot
    double sd_m = 0.5;
    double sd_rad = 0.26;
};

/// What is known about being in the right place, after an update.
struct Standing {
    /// Of the pose of the update: that the robot is neither lost nor at one of the other places that fit. 0..1
    double probability = 0.0;
    double lost = 0.0;          ///< the probability that the map explains the scans nowhere where there are particles
    double mode_weight = 0.0;   ///< of the place of the pose among all places where there are particles
    std::size_t modes = 0;      ///< such places
    std::size_t particles = 0;  ///< before resampling
    double support = 0.0;       ///< the share of the scan that the map explains at the pose
    bool searched = false;      ///< whether the whole map was searched in this update
    PlaceState place = PlaceState::searching;
};

/// What becomes of the map once the robot is surely found.
enum class MapUse {
    fixed,    ///< it stays as it is
    going_on  ///< from then on scans enter it, and each particle has its own
};

/// Follows a robot in a map that does not change: an Rbpf in a known map, with a search of the whole map at the start
/// and where it seems to be lost. What the search finds joins the particles as further places, and the drive tells
/// which one is right. With MapUse::going_on it maps on where it has found itself, in the frame of the map.
class Localizer : public ParticleFilter {
public:
    /// \param settings cells must be of the size of the map's; likelihood_gain above 0
    /// \param strategies as for an Rbpf; the resampling is replaced
    /// `threads` must outlive the filter. Throws Error if nothing was observed in the map.
    Localizer(const RbpfSettings& settings, const ModeResamplingSettings& particles, ThreadPool& threads,
              FilterStrategies strategies, std::shared_ptr<const OccupancyGrid> map, std::optional<StartPose> start,
              MapUse use = MapUse::fixed);

    /// The robot is here at the next frame, as somebody has told who sees it. The particles begin anew about this
    /// place, but what was learnt of the odometry and of the map stays. Not while mapping.
    void expect_at(const StartPose& place);

    std::optional<Update> update(const SensorFrame& frame) override;

    [[nodiscard]] const OccupancyGrid& map() const override { return filter_.map(); }
    [[nodiscard]] Pose2 pose() const override { return filter_.pose(); }
    [[nodiscard]] Eigen::Matrix3d pose_covariance() const override { return filter_.pose_covariance(); }
    void visit_trajectory(const PoseVisitor& visit) const override { filter_.visit_trajectory(visit); }
    [[nodiscard]] std::optional<OdometryState> odometry_state() const override { return filter_.odometry_state(); }

    /// Whether scans enter the map by now.
    [[nodiscard]] bool is_mapping() const { return is_mapping_; }
    /// As of the latest update before mapping.
    [[nodiscard]] const Standing& standing() const { return standing_; }

private:
    [[nodiscard]] std::vector<Hypothesis> at_start(const ScanPoints& points);
    [[nodiscard]] std::vector<Hypothesis> about(const StartPose& start) const;
    [[nodiscard]] std::vector<Hypothesis> found_places(const ScanPoints& points,
                                                       std::span<const SnapshotParticle> known, double weight);
    [[nodiscard]] bool search_is_due() const;

    RbpfSettings settings_;
    ModeResamplingSettings particles_;
    std::shared_ptr<const OccupancyGrid> map_;
    std::optional<StartPose> start_;
    MapUse use_;
    bool is_mapping_ = false;
    double sure_m_ = 0.0;  ///< driven since the robot was last not sure of its place
    Rbpf filter_;
    GlobalSearch search_;
    LostWatch watch_;
    PlaceTrust trust_;
    Standing standing_;
    bool started_ = false;
    bool complete_ = true;  ///< whether the last search found all places that fit
    double since_search_m_ = 0.0;
    double search_every_m_ = 0.0;
};

}  // namespace ddtool::localization

#pragma once

#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/filter/odometry_model.hpp"
#include "ddtool/filter/scan_matcher.hpp"
#include "ddtool/swarm/degeneracy_detector.hpp"

namespace ddtool {

/// One particle's match, with all that a second look at it may need.
struct MatchContext {
    ScanMatcher& matcher;       ///< the calling thread's own
    const OccupancyGrid& grid;  ///< the particle's map, without this scan
    const MatchPoints& points;
    Pose2 predicted;  ///< world_from_robot, sampled from the motion model
    PosePrior prior;  ///< about `predicted`, that the match was made with
    Pose2 odometry;   ///< world_from_robot, the likeliest by the odometry model
    /// Of (x, y, theta) in the world: what odometry says of the pose since the scans last told as much.
    Eigen::Matrix3d odometry_information;
    Degeneracy degeneracy;  ///< of the whole swarm
};

/// May replace the pose that scan matching found, knowing how degenerate the swarm is. One object serves all particles
/// and is called by many threads at once; it holds settings only.
class PoseCorrection {
public:
    virtual ~PoseCorrection() = default;
    /// The match to go on with: `found` or another, whose pose, score, information and likelihood belong together.
    virtual ScanMatch correct(const MatchContext& context, const ScanMatch& found) const = 0;
};

/// A particle after resampling: a copy of `parent`, standing at `pose`.
struct Descendant {
    std::size_t parent = 0;
    Pose2 pose;  ///< world_from_robot
};

/// Chooses the next generation from poses and normalised weights. Called by one thread at a time; it holds settings
/// only, and all chance comes from `random`.
class Resampling {
public:
    virtual ~Resampling() = default;
    /// As many descendants as there are particles.
    virtual std::vector<Descendant> resample(std::span<const SnapshotParticle> particles,
                                             RandomStream& random) const = 0;
};

/// Systematic resampling; poses stay as they are.
class SystematicResampling : public Resampling {
public:
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, RandomStream& random) const override;
};

/// What makes a method of the filter. Empty members mean: never degenerate, keep the match, resample systematically,
/// take the odometry as it is. Copies share the parts, none of which has a state that changes; the odometry model,
/// which learns, is made anew for each filter.
struct FilterStrategies {
    DegeneracyDetector detector;
    std::vector<std::shared_ptr<const PoseCorrection>> corrections;  ///< each takes what the one before found
    std::shared_ptr<const Resampling> resampling;
    std::function<std::unique_ptr<OdometryModel>()> odometry;
};

}  // namespace ddtool

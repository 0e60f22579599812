#pragma once

#include <memory>
#include <span>
#include <vector>

#include "base/random.hpp"
#include "particles/degeneracy_detector.hpp"
#include "slam/scan_matcher.hpp"

namespace ddtool {

/// One particle's match, with all that a second look at it may need.
struct MatchContext {
    ScanMatcher& matcher;
    const OccupancyGrid& grid;
    const MatchPoints& points;
    Pose2 predicted;  ///< world_from_robot, sampled from the motion model
    Pose2 odometry;   ///< world_from_robot by the odometry motion without noise
    PosePrior prior;
};

/// May replace the pose that scan matching found, knowing how degenerate the swarm is.
class PoseCorrection {
public:
    virtual ~PoseCorrection() = default;
    virtual ScanMatch correct(const MatchContext& context, const ScanMatch& found,
                              const Degeneracy& degeneracy) const = 0;
};

/// A particle after resampling: a copy of `parent`, standing at `pose`.
struct Descendant {
    std::size_t parent = 0;
    Pose2 pose;
};

/// Chooses the next generation from poses and normalised weights.
class Resampling {
public:
    virtual ~Resampling() = default;
    virtual std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, const Degeneracy& degeneracy,
                                             RandomStream& random) const = 0;
};

/// Systematic resampling; poses stay as they are.
class SystematicResampling : public Resampling {
public:
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, const Degeneracy& degeneracy,
                                     RandomStream& random) const override;
};

/// What makes a method of the filter. Empty members mean: never degenerate, keep the match, resample systematically.
struct FilterStrategies {
    DegeneracyDetector detector;
    std::shared_ptr<const PoseCorrection> correction;
    std::shared_ptr<const Resampling> resampling;
};

}  // namespace ddtool

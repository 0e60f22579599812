#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/filter/odometry_model.hpp"
#include "ddtool/filter/scan_matcher.hpp"
#include "ddtool/swarm/degeneracy_detector.hpp"

namespace ddtool {

/// The match of one particle, with everything that a correction may need.
struct MatchContext {
    ScanMatcher& matcher;       ///< belongs to the calling thread
    const OccupancyGrid& grid;  ///< the particle's map, without this scan
    const MatchPoints& points;
    Pose2 predicted;  ///< world_from_robot, sampled from the motion model
    PosePrior prior;  ///< uncertainty about `predicted` that the match was made with
    Pose2 odometry;   ///< world_from_robot, the most likely pose according to the odometry model
    /// Information about (x, y, theta) in the world that the odometry gives: of its motion since the last update.
    Eigen::Matrix3d odometry_information;
    Degeneracy degeneracy;  ///< of the whole swarm
    /// Factor on the information of a match: the matcher assumes one noise of the beams for every lidar.
    double information_factor = 1.0;
    /// In a known map: the information about (x, y, theta) in the world that all before this scan gives, which is less
    /// than that of the odometry's last motion alone.
    std::optional<Eigen::Matrix3d> pose_information = std::nullopt;
    /// In a known map: the result for a particle nearby whose match this one has taken over, or null if it was matched
    /// itself. How much of the match can be believed is the same for both, and where the poses hardly differ, so is how
    /// the scan fits.
    const ScanMatch* alike = nullptr;
};

/// May replace the pose that scan matching found, given how degenerate the swarm is. One object serves all particles
/// and is called by many threads at once, so it holds only settings.
class PoseCorrection {
public:
    virtual ~PoseCorrection() = default;
    /// Returns the match to continue with: `found` or another. Its pose, score, information and likelihood must belong
    /// together.
    virtual ScanMatch correct(const MatchContext& context, const ScanMatch& found) const = 0;
};

/// A particle after resampling: a copy of the particle with index `parent`, placed at `pose`.
struct Descendant {
    std::size_t parent = 0;
    Pose2 pose;           ///< world_from_robot
    double weight = 1.0;  ///< relative to the other descendants
};

/// Chooses the next generation from poses and normalised weights. It is called by one thread at a time and holds only
/// settings; all randomness comes from `random`.
class Resampling {
public:
    virtual ~Resampling() = default;
    /// Whether the swarm should be resampled although its weights are even enough, for another number of particles.
    [[nodiscard]] virtual bool is_due(std::span<const SnapshotParticle> /*particles*/) const { return false; }
    /// Returns as many descendants as there are particles; in a known map (Rbpf) there may be more or fewer.
    virtual std::vector<Descendant> resample(std::span<const SnapshotParticle> particles,
                                             RandomStream& random) const = 0;
};

/// Systematic resampling; poses stay as they are.
class SystematicResampling : public Resampling {
public:
    std::vector<Descendant> resample(std::span<const SnapshotParticle> particles, RandomStream& random) const override;
};

/// The parts that make a method of the filter. Where a member is empty, the swarm never counts as degenerate, the match
/// is kept, resampling is systematic, or the odometry is taken as it is. Copies share the corrections and the
/// resampling, which hold only settings. Each copy has its own detector, though the detectors of copies may share a
/// network (network_detector()). The odometry model, which learns, is made anew for each filter.
struct FilterStrategies {
    DegeneracyDetector detector;
    /// Applied in order, each to the result of the one before.
    std::vector<std::shared_ptr<const PoseCorrection>> corrections;
    std::shared_ptr<const Resampling> resampling;
    std::function<std::unique_ptr<OdometryModel>()> odometry;
};

}  // namespace ddtool

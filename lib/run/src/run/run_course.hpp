#pragma once

#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "run/worst_moments.hpp"

namespace ddtool {

/// What happened update by update, but for the first, which only starts the map; for pictures, so that of a long run
/// every second update is enough, then every fourth, and so on: memory stays bounded. All lists are of the same length.
class RunCourse {
public:
    RunCourse() = default;
    /// Between most / 2 and most updates are kept, once there were as many; an even number.
    explicit RunCourse(std::size_t most) : most_(most) {}

    /// The swarm of an update, before it is over.
    void see(const ParticleSnapshot& swarm, const Degeneracy& degeneracy);
    /// After each update of the filter.
    void add(const Rbpf& filter);

    /// `resampled` tells of those left out behind it, too.
    [[nodiscard]] const std::vector<UpdateReport>& updates() const { return updates_; }
    /// Before resampling.
    [[nodiscard]] const std::vector<double>& effective_sizes() const { return effective_sizes_; }
    /// Wall time in the filter. Other than all else here it differs from run to run.
    [[nodiscard]] const std::vector<double>& step_s() const { return step_s_; }
    [[nodiscard]] const WorstMoments& worst() const { return worst_; }

private:
    void halve();

    std::size_t most_ = 1U << 16U;
    std::size_t every_ = 1;  ///< one of so many updates is kept
    std::size_t seen_ = 0;
    std::vector<UpdateReport> updates_;
    std::vector<double> effective_sizes_;
    std::vector<double> step_s_;
    WorstMoments worst_;
    double effective_size_ = 0.0;  ///< of the swarm last seen
    double filter_s_ = 0.0;        ///< in the filter so far
};

/// Where the robot was at each update, by the path of the whole run, which has a pose for every scan.
Trajectory places_of(const std::vector<UpdateReport>& updates, const Trajectory& path);

}  // namespace ddtool

#pragma once

#include <cstdint>

#include "ddtool/filter/update.hpp"

namespace ddtool::check {

/// What the updates of a run say of odometry and matching, gathered while the run goes on.
struct OdometryEvidence {
    std::uint64_t updates = 0;
    double odometry_m = 0.0;  ///< sum of the motions between updates
    double matched_m = 0.0;
    double odometry_turn_rad = 0.0;  ///< sum of the turns' magnitudes
    double along = 1.0;    ///< regression of the matched motion on the odometry's, along it: 1 where they agree
    double across = 0.0;   ///< the same across it: 0 where they agree; a laser yawed on the robot shows here
    double turn = 1.0;     ///< regression of the matched turn on the odometry's
    double scatter_m = 0.0;  ///< root of the mean squared difference of the two motions
    std::uint64_t jumps = 0;  ///< updates in which the two differ by more than wheels can
    double worst_jump_m = 0.0;
    double worst_jump_rad = 0.0;
    double mean_score = 0.0;        ///< of the match, in 0..1
    std::uint64_t unmatched = 0;    ///< updates whose scan fits the map nowhere
    std::uint64_t poor = 0;    ///< updates whose scan fits the map badly
};

class OdometryWitness {
public:
    void add(const Update& update);
    [[nodiscard]] OdometryEvidence evidence() const;

private:
    OdometryEvidence sums_;
    double dot_ = 0.0, cross_ = 0.0, squares_ = 0.0;
    double turn_dot_ = 0.0, turn_squares_ = 0.0;
    double difference2_ = 0.0;
    double scores_ = 0.0;
};

}  // namespace ddtool::check

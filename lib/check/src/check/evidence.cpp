#include "check/evidence.hpp"

namespace ddtool::check {
namespace {

Json pairs_json(const PairEvidence& pairs) {
    return {{"pairs", pairs.pairs},   {"contradicted", pairs.contradicted}, {"median", pairs.median},
            {"p90", pairs.p90}, {"bad", pairs.bad}};
}

}  // namespace

Json to_json_object(const Evidence& evidence) {
    const OdometryEvidence& odometry = evidence.odometry;
    return {{"scans", evidence.scans},
            {"neighbours", pairs_json(evidence.neighbours)},
            {"revisits", pairs_json(evidence.revisits)},
            {"odometry_neighbours", pairs_json(evidence.odometry_neighbours)},
            {"odometry_revisits", pairs_json(evidence.odometry_revisits)},
            {"odometry",
             {{"updates", odometry.updates},
              {"odometry_m", odometry.odometry_m},
              {"matched_m", odometry.matched_m},
              {"odometry_turn_rad", odometry.odometry_turn_rad},
              {"along", odometry.along},
              {"across", odometry.across},
              {"turn", odometry.turn},
              {"scatter_m", odometry.scatter_m},
              {"jumps", odometry.jumps},
              {"worst_jump_m", odometry.worst_jump_m},
              {"worst_jump_rad", odometry.worst_jump_rad},
              {"mean_score", odometry.mean_score},
              {"unmatched", odometry.unmatched},
              {"poor", odometry.poor}}},
            {"open",
             {{"odometry_m", evidence.open.odometry_m},
              {"path_m", evidence.open.path_m},
              {"held_odometry_m", evidence.open.held_odometry_m},
              {"held_path_m", evidence.open.held_path_m},
              {"held_worst", evidence.open.held_worst},
              {"worst_m", evidence.open.worst_m}}}};
}

}  // namespace ddtool::check

#include "check/evidence.hpp"

namespace ddtool::check {
namespace {

Json pairs_json(const PairEvidence& pairs) {
    return {{"pairs", pairs.pairs}, {"contradicted", pairs.contradicted}, {"p90", pairs.p90}, {"bad", pairs.bad}};
}

Json motion_json(const MotionEvidence& motion) {
    return {{"updates", motion.updates},
            {"odometry_m", motion.odometry_m},
            {"matched_m", motion.matched_m},
            {"odometry_turn_rad", motion.odometry_turn_rad},
            {"along", motion.along},
            {"across", motion.across},
            {"turn", motion.turn},
            {"lever_m", {motion.lever_m.x_m, motion.lever_m.y_m}},
            {"usual_m", motion.usual_m},
            {"jumps", motion.jumps},
            {"worst_jump_m", motion.worst_jump_m},
            {"worst_jump_rad", motion.worst_jump_rad},
            {"score", motion.score},
            {"usual_score", motion.usual_score},
            {"seam",
             {{"score", motion.seam.score},
              {"best_particle", motion.seam.best_particle},
              {"s", motion.seam.s},
              {"moved_m", motion.seam.moved_m},
              {"turned_rad", motion.seam.turned_rad}}},
            {"unmatched", motion.unmatched},
            {"open",
             {{"odometry_m", motion.open.odometry_m},
              {"matched_m", motion.open.matched_m},
              {"worst_stretch_m", motion.open.worst_stretch_m},
              {"worst_length_m", motion.open.worst_length_m},
              {"worst_updates", motion.open.worst_updates},
              {"worst_step_m", motion.open.worst_step_m},
              {"worst_blind_turn_rad", motion.open.worst_blind_turn_rad},
              {"worst_blind_m", motion.open.worst_blind_m}}}};
}

}  // namespace

Json evidence_json(const Evidence& evidence) {
    return {{"scans", evidence.scans},
            {"all_scans", evidence.all_scans},
            {"blind_scans", evidence.blind_scans},
            {"neighbours", pairs_json(evidence.neighbours)},
            {"revisits", pairs_json(evidence.revisits)},
            {"odometry_revisits", pairs_json(evidence.odometry_revisits)},
            {"from_odometry_m", evidence.from_odometry_m},
            {"motion", motion_json(evidence.motion)},
            {"steps",
             {{"moving", evidence.steps.moving},
              {"stairs", evidence.steps.stairs},
              {"lost", evidence.steps.lost},
              {"longest_lost_s", evidence.steps.longest_lost_s},
              {"usual_m_per_s", evidence.steps.usual_m_per_s}}}};
}

}  // namespace ddtool::check

#include "scores/trajectory_score.hpp"

#include <string>

namespace ddtool {
namespace {

struct NamedStatistics {
    std::string title;
    std::string key;
    ErrorStatistics statistics;
};

std::vector<NamedStatistics> all_statistics(const TrajectoryScore& score) {
    std::vector<NamedStatistics> all;
    if (score.absolute) {
        all.push_back({"ATE [m]", "ate_m", score.absolute->translation_m});
        all.push_back({"Error_x [m]", "error_x_m", score.absolute->error_x_m});
        all.push_back({"Error_y [m]", "error_y_m", score.absolute->error_y_m});
    }
    if (score.relative) {
        all.push_back({"RPE translation [m]", "rpe_m", score.relative->translation_m});
        all.push_back({"RPE rotation [deg]", "rpe_deg", score.relative->rotation_deg});
    }
    if (score.relations) {
        all.push_back({"relations, translation [m]", "relations_m", score.relations->translation_m});
        all.push_back({"relations, rotation [deg]", "relations_deg", score.relations->rotation_deg});
    }
    return all;
}

}  // namespace

TrajectoryScore score_against(const Trajectory& estimate, const Trajectory& reference, const ScoreOptions& options) {
    TrajectoryScore score;
    score.absolute = absolute_trajectory_error(estimate, reference, options.ate);
    score.relative = relative_pose_error(score.absolute->pairs, options.rpe_delta);
    return score;
}

Table score_table(const TrajectoryScore& score) {
    Table table({{"error"}, {"rmse", 4}, {"mean", 4}, {"median", 4}, {"std", 4}, {"min", 4}, {"max", 4}, {"count"}});
    for (const auto& [title, key, statistics] : all_statistics(score)) {
        table.add_row({title, statistics.rmse, statistics.mean, statistics.median, statistics.std, statistics.min,
                       statistics.max, static_cast<std::int64_t>(statistics.count)});
    }
    return table;
}

Json score_json(const TrajectoryScore& score) {
    Json json = Json::object();
    for (const auto& [title, key, statistics] : all_statistics(score)) {
        json[key] = statistics;
    }
    if (score.absolute) {
        const Pose2& alignment = score.absolute->reference_from_estimate;
        json["reference_from_estimate"] = {
            {"x_m", alignment.x_m}, {"y_m", alignment.y_m}, {"theta_rad", alignment.theta_rad}};
    }
    if (score.relations) {
        json["relations_skipped"] = score.relations->skipped;
    }
    return json;
}

}  // namespace ddtool

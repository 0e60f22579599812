#include <iostream>
#include <memory>

#include "commands.hpp"
#include "scores/trajectory_plot.hpp"
#include "scores/trajectory_score.hpp"
#include "scores/tum_file.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

struct ScoreRequest {
    std::string trajectory;
    std::string reference;
    std::string relations;
    std::string plot;
    bool as_json = false;
};

double time_tolerance_s(const Json& settings) {
    const double tolerance_s = settings.at("max_time_difference_s");
    if (!(tolerance_s >= 0.0)) {
        throw UsageError("max_time_difference_s: expected a number of seconds, 0 or more");
    }
    return tolerance_s;
}

ScoreOptions score_options(const Json& settings) {
    return {.ate = {.alignment = parse_alignment(settings.at("align").get<std::string>()),
                    .max_time_difference_s = time_tolerance_s(settings)},
            .rpe_delta = {.value = settings.at("rpe").at("delta"),
                          .unit = parse_delta_unit(settings.at("rpe").at("unit").get<std::string>())}};
}

Trajectory read_poses(const std::string& file) {
    Trajectory trajectory = read_tum(file);
    if (trajectory.empty()) {
        throw Error(file + ": no poses");
    }
    return trajectory;
}

RelationErrors read_and_score_relations(const Trajectory& trajectory, const std::string& file, double tolerance_s) {
    const std::vector<Relation> relations = read_relations(file);
    RelationErrors errors = score_relations(trajectory, relations, tolerance_s);
    if (errors.skipped == relations.size()) {
        throw Error(file + ": none of its " + std::to_string(relations.size()) +
                    " relations has both times in the trajectory");
    }
    return errors;
}

ExitCode score(const ScoreRequest& request, const Json& settings) {
    if (request.reference.empty() && request.relations.empty()) {
        throw UsageError("score: expected --reference, --relations or both");
    }
    const ScoreOptions options = score_options(settings);
    const Trajectory estimate = read_poses(request.trajectory);
    TrajectoryScore result;
    if (!request.reference.empty()) {
        const Trajectory reference = read_poses(request.reference);
        result = score_against(estimate, reference, options);
        log_info(std::to_string(result.absolute->pairs.size()) + " of " + std::to_string(estimate.size()) +
                 " poses have a partner in the reference");
    }
    if (!request.relations.empty()) {
        result.relations = read_and_score_relations(estimate, request.relations, options.ate.max_time_difference_s);
    }
    if (result.absolute && !request.plot.empty()) {
        ate_figure(*result.absolute).write_png(request.plot);
    }
    std::cout << (request.as_json ? score_json(result).dump(2) + "\n" : score_table(result).text());
    if (result.relations && result.relations->skipped > 0) {
        log_warning(request.relations + ": " + std::to_string(result.relations->skipped) +
                    " relations skipped: their times are not in the trajectory");
        return ExitCode::done_with_loss;
    }
    return ExitCode::done;
}

}  // namespace

Command score_command() {
    const auto request = std::make_shared<ScoreRequest>();
    return {
        .name = "score",
        .summary = "Errors of a trajectory against the truth",
        .example = "ddtool score --trajectory out/trajectory.tum --reference truth.tum --plot errors.png",
        .settings = {{"align", "se2"},
                     {"max_time_difference_s", default_max_time_difference_s},
                     {"rpe", {{"delta", 1.0}, {"unit", "frames"}}}},
        .options =
            {
                {"--trajectory", &request->trajectory, "The estimate", "FILE.tum", Presence::required},
                {"--reference", &request->reference, "True trajectory: ATE, RPE, Error_x, Error_y", "FILE.tum"},
                {"--relations", &request->relations, "True relative poses: t1 t2 x y z roll pitch yaw a line", "FILE"},
                {.name = "--plot",
                 .value = &request->plot,
                 .help = "Picture of both trajectories and of the error over time",
                 .type = "FILE.png",
                 .needs = "--reference"},
                {"--json", &request->as_json, "Print JSON instead of a table"},
                {"--align", SettingPath{"align"}, "Motion granted to the estimate first", "none|first|se2"},
                {"--max-time-difference", SettingPath{"max_time_difference_s"},
                 "Stamps at most this many seconds apart are one moment"},
                {"--rpe-delta", SettingPath{"rpe.delta"}, "How far apart the two poses of an RPE motion are"},
                {"--rpe-unit", SettingPath{"rpe.unit"}, "Of the RPE delta", "frames|metres|seconds"},
            },
        .run = [request](const Json& settings) { return score(*request, settings); }};
}

}  // namespace ddtool

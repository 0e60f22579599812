#include "score_command.hpp"

#include <iostream>

#include "scores/trajectory_plot.hpp"
#include "scores/trajectory_score.hpp"
#include "scores/tum_file.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

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

}  // namespace

ScoreCommand::ScoreCommand()
    : Command("score", "Errors of a trajectory against the truth",
              "ddtool score --trajectory out/trajectory.tum --reference truth.tum --plot errors.png") {}

void ScoreCommand::add_options(CLI::App& app) {
    app.add_option("--trajectory", trajectory_file_, "The estimate")->type_name("FILE.tum")->required();
    app.add_option("--reference", reference_file_, "True trajectory: ATE, RPE, Error_x, Error_y")
        ->type_name("FILE.tum");
    app.add_option("--relations", relations_file_, "True relative poses: t1 t2 x y z roll pitch yaw a line")
        ->type_name("FILE");
    app.add_option("--plot", plot_file_, "Picture of both trajectories and of the error over time")
        ->type_name("FILE.png")
        ->needs("--reference");
    app.add_flag("--json", as_json_, "Print JSON instead of a table");
    bind_option(app, "--align", "align", "Motion granted to the estimate first")->type_name("none|first|se2");
    bind_option(app, "--max-time-difference", "max_time_difference_s",
                "Stamps at most this many seconds apart are one moment");
    bind_option(app, "--rpe-delta", "rpe.delta", "How far apart the two poses of an RPE motion are");
    bind_option(app, "--rpe-unit", "rpe.unit", "Of the RPE delta")->type_name("frames|metres|seconds");
}

Json ScoreCommand::default_settings() const {
    return {{"align", "se2"},
            {"max_time_difference_s", default_max_time_difference_s},
            {"rpe", {{"delta", 1.0}, {"unit", "frames"}}}};
}

ExitCode ScoreCommand::run(const Json& settings) {
    if (reference_file_.empty() && relations_file_.empty()) {
        throw UsageError("score: expected --reference, --relations or both");
    }
    const ScoreOptions options = score_options(settings);
    const Trajectory estimate = read_poses(trajectory_file_);
    TrajectoryScore score;
    if (!reference_file_.empty()) {
        const Trajectory reference = read_poses(reference_file_);
        score = score_against(estimate, reference, options);
        log_info(std::to_string(score.absolute->pairs.size()) + " of " + std::to_string(estimate.size()) +
                 " poses have a partner in the reference");
    }
    if (!relations_file_.empty()) {
        score.relations = read_and_score_relations(estimate, relations_file_, options.ate.max_time_difference_s);
    }
    if (score.absolute && !plot_file_.empty()) {
        plot::error_figure(*score.absolute).write_png(plot_file_);
    }
    std::cout << (as_json_ ? score_json(score).dump(2) + "\n" : score_table(score).text());
    if (score.relations && score.relations->skipped > 0) {
        log_warning(relations_file_ + ": " + std::to_string(score.relations->skipped) +
                    " relations skipped: their times are not in the trajectory");
        return ExitCode::done_with_loss;
    }
    return ExitCode::done;
}

}  // namespace ddtool

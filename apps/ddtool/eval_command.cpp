#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "ablation_report.hpp"
#include "assumed_inputs.hpp"
#include "commands.hpp"
#include "dataset/dataset.hpp"
#include "output_folder.hpp"
#include "recipe_option.hpp"
#include "study/judge/evaluation_page.hpp"
#include "study/judge/label_noise.hpp"
#include "study/judge/model_scorer.hpp"
#include "study/judge/nearest_neighbour.hpp"
#include "study/judge/pictures.hpp"
#include "study/judge/simple_rules.hpp"
#include "study/judge/tables.hpp"
#include "system/atomic_file.hpp"
#include "system/expect.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"
#include "train/engine.hpp"

namespace ddtool {
namespace {

using judge::Evaluation;
using judge::Task;

struct EvalRequest {
    std::string data = standard_dataset;
    bool names_data = false;
    std::vector<std::string> models;
    std::string fit;
    std::string out;
    std::string ablation;
    std::string recipe = train::best_recipe_name;
    bool label_noise = false;
    bool nearest_neighbour = false;
    bool as_json = false;
};

Task task_from(const Json& settings) {
    const auto place = [&](const std::string& key, std::span<const char* const> names) {
        return expect_one_of(key, settings.at(key), names);
    };
    return {.label = dataset::LabelRule{place("label", dataset::label_rule_names)},
            .split = dataset::Split{place("split", dataset::split_names)},
            .part = static_cast<dataset::Part>(1 + place("part", std::span(dataset::part_names).subspan(1)))};
}

std::vector<judge::Detector> rules_fitted_on(const std::string& folder, const Task& task) {
    std::vector<judge::Detector> rules = judge::fitted_rules(dataset::Dataset(folder), task.label, task.split);
    if (std::isnan(rules.front().threshold)) {
        log_warning(folder + ": no sample of one of the classes to fit rules on: they have scores, but decide nothing");
    }
    return rules;
}

/// Appends the names of their files to the names of models that share a name and a seed.
void tell_apart(std::vector<judge::Detector>& models, const std::vector<std::string>& files) {
    std::map<std::pair<std::string, std::optional<std::uint64_t>>, std::size_t> count;
    for (const judge::Detector& model : models) {
        ++count[{model.name, model.seed}];
    }
    for (std::size_t index = 0; index < models.size(); ++index) {
        if (count[{models[index].name, models[index].seed}] > 1) {
            models[index].name += " [" + files[index] + "]";
        }
    }
}

std::vector<judge::Detector> load_models(const std::vector<std::string>& files, const Json& options) {
    std::vector<judge::Detector> models;
    models.reserve(files.size());
    for (const std::string& file : files) {
        models.push_back(
            judge::detector_of(train::engine().load(file, {.device = options.at("device"),
                                                           .precision = options.at("precision"),
                                                           .threads = options.at("threads").get<std::size_t>()})));
    }
    tell_apart(models, files);
    return models;
}

void print(const dataset::Dataset& data, const std::vector<Evaluation>& evaluations, const Task& task) {
    std::string text;
    for (const judge::NamedTable& each : judge::evaluation_tables(data, evaluations, task)) {
        text += (text.empty() ? "" : "\n") + each.table.text();
    }
    std::cout << text;
}

report::Page page_of(const std::filesystem::path& folder, const std::string& data_name, const dataset::Dataset& data,
                     const std::vector<Evaluation>& evaluations, const Task& task) {
    report::Page page("ddtool eval", report::folder_name(folder));
    page.text("Data set " + data_name + ", " + name_of(task) + ".");
    judge::add_evaluations(page, folder, data, evaluations, task);
    return page;
}

/// Whether an ablation in the folder was stopped. What it has trained is not trained again.
bool is_unfinished_ablation(const std::filesystem::path& folder) {
    return is_folder(folder / "models") && !std::filesystem::exists(folder / "ablation.json");
}

ExitCode ablate(const EvalRequest& request, const Json& options) {
    const train::Engine& engine = train::engine();
    const std::filesystem::path data = data_folder(request.data, request.names_data);
    const ablation::Machine machine{.device = options.at("device"), .threads = options.at("threads")};
    const ablation::Plan plan = read_ablation_plan(request.ablation, machine);
    const OutputFolder output(request.out, "ablation", is_unfinished_ablation);
    return run_ablation(engine, request.ablation, plan, data, output.path(), machine, request.as_json);
}

/// The models that the user has named or, if they have named neither data set nor model, the newest beside the data set
/// that is then assumed.
std::vector<std::string> tested_models(const EvalRequest& request) {
    if (request.names_data || !request.models.empty()) {
        return request.models;
    }
    const std::optional<std::filesystem::path> newest = newest_model_in(".");
    if (!newest) {
        return {};
    }
    return {newest->lexically_normal().string()};
}

/// Tells what was assumed. It is called after the models are loaded, because that may start the command anew.
void tell_of_assumed(const EvalRequest& request, const std::vector<std::string>& models) {
    if (!request.names_data && request.models.empty()) {
        log_info(models.empty() ? "no --model, and no network beside the data set: only the simple rules are tested"
                                : "no --model: testing " + models.front() + ", the newest network beside the data set");
    }
}

void print(const Table& table, bool as_json) { std::cout << (as_json ? table.json().dump(2) + "\n" : table.text()); }

void print_label_noise(const EvalRequest& request, const dataset::Dataset& data) {
    const Table table = judge::label_noise_table(data);
    if (table.empty()) {
        throw Error(request.data +
                    ": no two of its runs differ in their seeds alone, as in configs/dataset/label-noise.json");
    }
    print(table, request.as_json);
}

/// The images as the networks of the recipe see them.
ImageSettings image_of(const std::string& recipe) {
    const auto found = std::ranges::find(train::recipes(), recipe, &train::Recipe::name);
    return found->training.at("image").get<ImageSettings>();
}

ExitCode evaluate(const EvalRequest& request, const Json& settings) {
    if (!request.ablation.empty()) {
        return ablate(request, settings.at("run"));
    }
    const Task task = task_from(settings);
    const std::vector<std::string> models = tested_models(request);
    std::vector<judge::Detector> detectors = load_models(models, settings.at("run"));
    const dataset::Dataset data(data_folder(request.data, request.names_data));
    tell_of_assumed(request, models);
    if (request.label_noise) {
        print_label_noise(request, data);
        return ExitCode::done;
    }
    if (request.nearest_neighbour) {
        print(judge::nearest_neighbour_table(data, image_of(request.recipe), task), request.as_json);
        return ExitCode::done;
    }
    for (judge::Detector& rule : rules_fitted_on(request.fit.empty() ? request.data : request.fit, task)) {
        detectors.push_back(std::move(rule));
    }
    std::vector<Evaluation> evaluations;
    evaluations.reserve(detectors.size());
    for (const judge::Detector& detector : detectors) {
        evaluations.push_back(judge::evaluate(data, detector, task));
    }
    const bool tested = !evaluations.front().samples.indices.empty();
    if (!tested) {
        log_warning(request.data + ": no samples for " + name_of(task) +
                    ": only their agreement with the physics is known");
    }
    const std::string report = judge::evaluation_json(data, evaluations, task).dump(2) + "\n";
    const OutputFolder output(request.out, "eval");
    const std::filesystem::path& folder = output.path();
    write_file(made_folder(folder) / "eval.json", report);
    if (tested) {
        judge::draw_evaluations(folder, data, evaluations, judge::detailed(evaluations).front());
        log_info("pictures in " + folder.string());
    }
    const bool has_page = report::write_page(folder / "report.html", [&] {
        return page_of(folder, report::folder_name(request.data), data, evaluations, task);
    });
    if (request.as_json) {
        std::cout << report;
    } else {
        print(data, evaluations, task);
    }
    log_info("next: ddtool eval --ablation" + (request.names_data ? " --data " + request.data : "") +
             ", which trains the paper's networks and compares them");
    return has_page ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace

Command eval_command() {
    const auto request = std::make_shared<EvalRequest>();
    const train::RunOptions run;
    return {
        .name = "eval",
        .summary = "How well models and simple rules detect degeneracy on a data set",
        .example = "ddtool eval --data out/small --model out/lite.pt --out out/evaluation",
        .settings = {{"label", "fisher"},
                     {"split", "held_out"},
                     {"part", "test"},
                     {"run", {{"device", run.device}, {"precision", run.precision}, {"threads", 0U}}}},
        .options =
            {
                {.name = "--data",
                 .value = &request->data,
                 .help = "The data set; if not given, the newest network beside it is tested, too",
                 .type = "DIR",
                 .given = &request->names_data},
                {"--model", &request->models, "An exported model or a checkpoint; may be given many times", "FILE.pt"},
                {"--fit", &request->fit,
                 "Data set whose part train the simple rules are fitted on, if not that of --data", "DIR"},
                {"--recipe", recipe_choice(&train::Recipe::evaluation, request->recipe),
                 "Label and split of the recipe that the models were trained with", "best|paper"},
                {"--label", SettingPath{"label"}, "What counts as degenerate", "dispersion|fisher"},
                {"--split", SettingPath{"split"}, "paper: samples at random; held_out: whole scenes", "paper|held_out"},
                {"--part", SettingPath{"part"}, "Samples that are tested", "train|validation|test"},
                {"--device", SettingPath{"run.device"}, "Where models run", "cpu|cuda"},
                {"--precision", SettingPath{"run.precision"}, "Of models", "fp32|bf16"},
                {"--threads", SettingPath{"run.threads"}, "Of models; 0 is one a core"},
                {.name = "--ablation",
                 .value = &request->ablation,
                 .help = "Instead: the table that the file plans; what --out lacks is trained. 'paper' is the paper's "
                         "table, and 'reduced' as much of it as this machine can train",
                 .type = "reduced|paper|FILE",
                 .alone = reduced_plan_name,
                 .excludes = "--model"},
                {"--label-noise", &request->label_noise,
                 "Instead: how often labels differ between runs of the data set that differ in their seeds alone"},
                {"--nearest-neighbour", &request->nearest_neighbour,
                 "Instead: how often the label is that of the nearest training image, among all of them and without "
                 "those of the sample's own run. The images are those of the recipe"},
                {"--out", &request->out,
                 "Folder for eval.json, report.html and pictures; if not given, a new one: 'eval', or 'ablation'",
                 "DIR"},
                {"--json", &request->as_json, "Print JSON instead of tables"},
            },
        .run = [request](const Json& settings) { return evaluate(*request, settings); }};
}

}  // namespace ddtool

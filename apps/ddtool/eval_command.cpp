#include "eval_command.hpp"

#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <utility>

#include "ablation_report.hpp"
#include "study/judge/evaluation_page.hpp"
#include "study/judge/label_noise.hpp"
#include "study/judge/model_scorer.hpp"
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

/// Models of one name and seed get the names of their files behind.
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

html::Page page_of(const std::filesystem::path& folder, const std::string& data_name, const dataset::Dataset& data,
                   const std::vector<Evaluation>& evaluations, const Task& task) {
    html::Page page("ddtool eval", html::name_of(folder));
    page.text("Data set " + data_name + ", " + name_of(task) + ".");
    judge::add_evaluations(page, folder, data, evaluations, task);
    return page;
}

}  // namespace

EvalCommand::EvalCommand()
    : Command("eval", "How well models and simple rules detect degeneracy on a data set",
              "ddtool eval --data out/small --model out/lite.pt --out out/evaluation") {}

void EvalCommand::add_options(CLI::App& app) {
    app.add_option("--data", data_, "The data set")->type_name("DIR")->required();
    app.add_option("--model", models_, "An exported model or a checkpoint; may be given many times")
        ->type_name("FILE.pt");
    app.add_option("--fit", fit_, "Data set whose part train the simple rules are fitted on, if not that of --data")
        ->type_name("DIR");
    bind_option(app, "--label", "label", "What counts as degenerate")->type_name("dispersion|fisher");
    bind_option(app, "--split", "split", "paper: samples at random; held_out: whole scenes")
        ->type_name("paper|held_out");
    bind_option(app, "--part", "part", "Samples that are tested")->type_name("train|validation|test");
    bind_option(app, "--device", "run.device", "Where models run")->type_name("cpu|cuda");
    bind_option(app, "--precision", "run.precision", "Of models")->type_name("fp32|bf16");
    bind_option(app, "--threads", "run.threads", "Of models; 0 is one a core");
    app.add_option("--ablation", ablation_, "Instead: the table that the file plans; what --out lacks is trained")
        ->type_name("FILE")
        ->expected(0, 1)
        ->default_str("configs/ablation/paper.json")
        ->excludes("--model");
    app.add_flag("--label-noise", label_noise_,
                 "Instead: how often labels differ between runs of the data set that differ in their seeds alone");
    app.add_option("--out", out_, "Write eval.json, report.html and pictures there")->type_name("DIR");
    app.add_flag("--json", as_json_, "Print JSON instead of tables");
}

Json EvalCommand::default_settings() const {
    const train::RunOptions run;
    return {{"label", "fisher"},
            {"split", "held_out"},
            {"part", "test"},
            {"run", {{"device", run.device}, {"precision", run.precision}, {"threads", 0U}}}};
}

ExitCode EvalCommand::ablate(const Json& options) const {
    if (out_.empty()) {
        throw UsageError("--ablation: expected --out, a folder for what it trains");
    }
    return run_ablation(train::engine(), ablation_, data_, out_,
                        {.device = options.at("device"), .threads = options.at("threads")}, as_json_);
}

void EvalCommand::print_label_noise(const dataset::Dataset& data) const {
    const Table table = judge::label_noise_table(data);
    if (table.empty()) {
        throw Error(data_ + ": no two of its runs differ in their seeds alone, as in configs/dataset/label-noise.json");
    }
    std::cout << (as_json_ ? table.json().dump(2) + "\n" : table.text());
}

ExitCode EvalCommand::run(const Json& settings) {
    if (!ablation_.empty()) {
        return ablate(settings.at("run"));
    }
    const Task task = task_from(settings);
    std::vector<judge::Detector> detectors = load_models(models_, settings.at("run"));
    const dataset::Dataset data(data_);
    if (label_noise_) {
        print_label_noise(data);
        return ExitCode::done;
    }
    for (judge::Detector& rule : rules_fitted_on(fit_.empty() ? data_ : fit_, task)) {
        detectors.push_back(std::move(rule));
    }
    std::vector<Evaluation> evaluations;
    evaluations.reserve(detectors.size());
    for (const judge::Detector& detector : detectors) {
        evaluations.push_back(judge::evaluate(data, detector, task));
    }
    const bool tested = !evaluations.front().samples.indices.empty();
    if (!tested) {
        log_warning(data_ + ": no samples for " + name_of(task) + ": only their agreement with the physics is known");
    }
    const std::string json = judge::evaluation_json(data, evaluations, task).dump(2) + "\n";
    if (!out_.empty()) {
        write_file(made_folder(out_) / "eval.json", json);
    }
    if (!out_.empty() && tested) {
        judge::draw_evaluations(out_, data, evaluations, judge::detailed(evaluations).front());
        log_info("pictures in " + out_);
    }
    const bool has_page = out_.empty() || html::write_page(std::filesystem::path(out_) / "report.html", [&] {
                              return page_of(out_, html::name_of(data_), data, evaluations, task);
                          });
    if (as_json_) {
        std::cout << json;
    } else {
        print(data, evaluations, task);
    }
    return has_page ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace ddtool

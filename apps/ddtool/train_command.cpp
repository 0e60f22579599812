#include <iostream>
#include <memory>

#include "assumed_inputs.hpp"
#include "commands.hpp"
#include "output_folder.hpp"
#include "recipe_option.hpp"
#include "system/log.hpp"
#include "train/engine.hpp"
#include "train/process_group.hpp"
#include "train_report.hpp"

namespace ddtool {
namespace {

struct TrainOptions {
    std::string data = standard_dataset;
    bool names_data = false;
    std::string out;
    std::string recipe = train::best_recipe_name;
    /// everything except the settings, and data and out, which the command line gives as text
    train::TrainRequest rest;
    bool as_json = false;
};

/// Throws UsageError if several processes train together but no folder is given: each would make one of its own.
void expect_shared_folder(const TrainOptions& options) {
    if (options.out.empty() && train::process_group()) {
        throw UsageError("--out: expected a folder, which the processes that train together share");
    }
}

std::string next_command(const train::TrainRequest& request, const train::TrainResult& result,
                         const TrainOptions& options) {
    const std::string recipe = options.recipe == train::best_recipe_name ? "" : " --recipe " + options.recipe;
    return options.names_data || !options.out.empty()
               ? "ddtool eval --data " + request.data.string() + " --model " + result.best.string() + recipe
               : "ddtool eval" + recipe;
}

ExitCode train_network(const TrainOptions& options, const Json& settings) {
    const train::Engine& engine = train::engine();
    train::TrainRequest request = options.rest;
    request.data = data_folder(options.data, options.names_data);
    request.settings = train::train_settings_from_json(settings);
    expect_shared_folder(options);
    const OutputFolder output(options.out, "train");
    request.out = output.path();
    const train::TrainResult result = engine.train(request);
    if (!result.leads) {
        return ExitCode::done;
    }
    if (result.interrupted) {
        log_warning("stopped after " + std::to_string(result.epochs) + " epochs; the same command with --out " +
                    output.path().string() + " --resume goes on");
        return ExitCode::failed;
    }
    if (options.as_json) {
        std::cout << result_json(request, result).dump(2) << '\n';
    } else {
        std::cout << result_table(result).text() << "checkpoint: " << result.best.string() << '\n';
    }
    const bool has_page = write_train_page(engine, request, result);
    log_info("next: " + next_command(request, result, options));
    return has_page ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace

Command train_command() {
    const auto options = std::make_shared<TrainOptions>();
    // a named object, because GCC 12 warns that a temporary might be used uninitialised
    const train::TrainSettings defaults;
    return {
        .name = "train",
        .summary = "Fits a network that reads the degree of degeneracy from particle images",
        .example = "ddtool train --data out/small --model ddmodel-lite --epochs 10 --out out/lite",
        .settings = defaults,
        .options =
            {
                {.name = "--data",
                 .value = &options->data,
                 .help = "The data set",
                 .type = "DIR",
                 .given = &options->names_data},
                {"--out", &options->out,
                 "Folder for checkpoints (best.pt, last.pt), metrics, curves and report.html; if not given, the new "
                 "one 'train'",
                 "DIR"},
                {"--recipe", recipe_choice(&train::Recipe::training, options->recipe),
                 "best: the network that ships; paper: label, swarm, split, network and augmentation of the paper",
                 "best|paper"},
                {"--model", SettingPath{"model"}, "The network, or a variant of it: docs/models.md",
                 "ddmodel|ddmodel-lite|mobilenetv3"},
                {"--label", SettingPath{"label"}, "What the network learns to tell", "fisher|dispersion"},
                {"--swarm", SettingPath{"image.swarm"}, "What of the swarm it sees", "response|step|absolute"},
                {"--split", SettingPath{"split"}, "held_out: whole scenes; paper: samples at random", "held_out|paper"},
                {"--loss", SettingPath{"loss"}, "What is minimised", "cross-entropy|bce"},
                {"--optimizer", SettingPath{"optimizer.name"}, "How it is minimised", "adam|rmsprop|adamw"},
                {"--epochs", SettingPath{"epochs"},
                 "Passes over the training part; the schedule of the rate depends on it"},
                {"--batch-size", SettingPath{"batch_size"}, "Images of a step, on each rank"},
                {"--precision", SettingPath{"precision"}, "Of the compute; bf16 is mixed", "bf16|fp32"},
                {"--seed", SettingPath{"seed"}, "Of weights, order and augmentation"},
                {"--device", &options->rest.device, "Where it is computed", "cpu|cuda"},
                {"--threads", &options->rest.threads, "Of the compute; 0 is one a core"},
                {.name = "--resume",
                 .value = &options->rest.resume,
                 .help = "Go on from OUT/last.pt, where it is there",
                 .needs = "--out"},
                {"--checkpoint-interval", &options->rest.checkpoint_interval_s,
                 "last.pt is written after every epoch, and at least so often", "SECONDS"},
                {"--json", &options->as_json, "Print JSON instead of a table"},
            },
        .run = [options](const Json& settings) { return train_network(*options, settings); }};
}

}  // namespace ddtool

#include "train_command.hpp"

#include <iostream>

#include "base/log.hpp"
#include "train_report.hpp"

namespace ddtool {
TrainCommand::TrainCommand()
    : Command("train", "Fits a network that reads the degree of degeneracy from particle images",
              "ddtool train --data out/small --model ddmodel-lite --epochs 10 --out out/lite") {}

void TrainCommand::add_options(CLI::App& app) {
    app.add_option("--data", request_.data, "The data set")->type_name("DIR")->required();
    app.add_option("--out", request_.out, "Folder for checkpoints (best.pt, last.pt), metrics, curves and report.html")
        ->type_name("DIR")
        ->required();
    bind_option(app, "--model", "model", "ddmodel, ddmodel-lite or mobilenetv3");
    bind_option(app, "--label", "label", "What the network learns to tell: fisher or dispersion");
    bind_option(app, "--swarm", "image.swarm", "What of the swarm it sees: response, step or absolute");
    bind_option(app, "--split", "split", "held_out or paper");
    bind_option(app, "--loss", "loss", "cross-entropy or bce");
    bind_option(app, "--optimizer", "optimizer.name", "adam, rmsprop or adamw");
    bind_option(app, "--epochs", "epochs", "Passes over the training part; the schedule of the rate depends on it");
    bind_option(app, "--batch-size", "batch_size", "Images of a step, on each rank");
    bind_option(app, "--precision", "precision", "bf16 (mixed) or fp32");
    bind_option(app, "--seed", "seed", "Of weights, order and augmentation");
    app.add_option("--device", request_.device, "cpu or cuda")->capture_default_str();
    app.add_option("--threads", request_.threads, "Of the compute; 0 is one a core")->capture_default_str();
    app.add_flag("--resume", request_.resume, "Go on from OUT/last.pt, where it is there");
    app.add_option("--checkpoint-interval", request_.checkpoint_interval_s,
                   "last.pt is written after every epoch, and at least so often")
        ->type_name("SECONDS")
        ->capture_default_str();
}

Json TrainCommand::default_settings() const {
    const learning::TrainSettings defaults;  // a temporary makes GCC 12 warn of one that is not initialised
    return defaults;
}

ExitCode TrainCommand::run(const Json& settings) {
    const learning::Engine& engine = learning::engine();
    request_.settings = settings.get<learning::TrainSettings>();
    const learning::TrainResult result = engine.train(request_);
    if (!result.leads) {
        return ExitCode::done;
    }
    if (result.interrupted) {
        log_warning("stopped after " + std::to_string(result.epochs) + " epochs; --resume goes on");
        return ExitCode::failed;
    }
    std::cout << result_table(result).text() << "checkpoint: " << result.best.string() << '\n';
    return write_train_page(engine, request_, result) ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace ddtool

#include "train_command.hpp"

#include <iostream>

#include "system/log.hpp"
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
    bind_option(app, "--model", "model", "The network")->type_name("ddmodel|ddmodel-lite|mobilenetv3");
    bind_option(app, "--label", "label", "What the network learns to tell")->type_name("fisher|dispersion");
    bind_option(app, "--swarm", "image.swarm", "What of the swarm it sees")->type_name("response|step|absolute");
    bind_option(app, "--split", "split", "held_out: whole scenes; paper: samples at random")
        ->type_name("held_out|paper");
    bind_option(app, "--loss", "loss", "What is minimised")->type_name("cross-entropy|bce");
    bind_option(app, "--optimizer", "optimizer.name", "How it is minimised")->type_name("adam|rmsprop|adamw");
    bind_option(app, "--epochs", "epochs", "Passes over the training part; the schedule of the rate depends on it");
    bind_option(app, "--batch-size", "batch_size", "Images of a step, on each rank");
    bind_option(app, "--precision", "precision", "Of the compute; bf16 is mixed")->type_name("bf16|fp32");
    bind_option(app, "--seed", "seed", "Of weights, order and augmentation");
    app.add_option("--device", request_.device, "Where it is computed")->type_name("cpu|cuda")->capture_default_str();
    app.add_option("--threads", request_.threads, "Of the compute; 0 is one a core")->capture_default_str();
    app.add_flag("--resume", request_.resume, "Go on from OUT/last.pt, where it is there");
    app.add_option("--checkpoint-interval", request_.checkpoint_interval_s,
                   "last.pt is written after every epoch, and at least so often")
        ->type_name("SECONDS")
        ->capture_default_str();
    app.add_flag("--json", as_json_, "Print JSON instead of a table");
}

Json TrainCommand::default_settings() const {
    const train::TrainSettings defaults;  // a temporary makes GCC 12 warn of one that is not initialised
    return defaults;
}

ExitCode TrainCommand::run(const Json& settings) {
    const train::Engine& engine = train::engine();
    request_.settings = settings.get<train::TrainSettings>();
    const train::TrainResult result = engine.train(request_);
    if (!result.leads) {
        return ExitCode::done;
    }
    if (result.interrupted) {
        log_warning("stopped after " + std::to_string(result.epochs) + " epochs; --resume goes on");
        return ExitCode::failed;
    }
    if (as_json_) {
        std::cout << result_json(request_, result).dump(2) << '\n';
    } else {
        std::cout << result_table(result).text() << "checkpoint: " << result.best.string() << '\n';
    }
    return write_train_page(engine, request_, result) ? ExitCode::done : ExitCode::done_with_loss;
}

}  // namespace ddtool

#include "export_command.hpp"

#include <iostream>

#include "system/log.hpp"
#include "train/engine.hpp"

namespace ddtool {

ExportCommand::ExportCommand()
    : Command("export", "Writes a trained network as TorchScript, and its plain weights beside it",
              "ddtool export --checkpoint out/lite/best.pt --out out/lite.pt") {}

void ExportCommand::add_options(CLI::App& app) {
    app.add_option("--checkpoint", checkpoint_, "best.pt or last.pt of ddtool train")->type_name("FILE")->required();
    app.add_option("--out", out_, "The model, MODEL.pt; plain weights go to MODEL.safetensors")
        ->type_name("FILE")
        ->required();
    app.add_flag("--json", as_json_, "Print JSON: what was written where");
}

ExitCode ExportCommand::run(const Json&) {
    train::engine().export_model(checkpoint_, out_);
    log_info("wrote " + out_);
    if (as_json_) {
        const Json report{{"command", "export"},
                          {"checkpoint", checkpoint_},
                          {"files", {{"torch_script", out_}, {"plain_weights", train::plain_weights_beside(out_)}}}};
        std::cout << report.dump(2) << '\n';
    }
    return ExitCode::done;
}

}  // namespace ddtool

#include "export_command.hpp"

#include "base/log.hpp"
#include "learning/engine.hpp"

namespace ddtool {

ExportCommand::ExportCommand()
    : Command("export", "Writes a trained network as TorchScript, and its plain weights beside it",
              "ddtool export --checkpoint out/lite/best.pt --out out/lite.pt") {}

void ExportCommand::add_options(CLI::App& app) {
    app.add_option("--checkpoint", checkpoint_, "best.pt or last.pt of ddtool train")->type_name("FILE")->required();
    app.add_option("--out", out_, "The model, MODEL.pt; plain weights go to MODEL.safetensors")
        ->type_name("FILE")
        ->required();
}

ExitCode ExportCommand::run(const Json&) {
    learning::engine().export_model(checkpoint_, out_);
    log_info("wrote " + out_);
    return ExitCode::done;
}

}  // namespace ddtool

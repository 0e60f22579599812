#include <iostream>
#include <memory>

#include "commands.hpp"
#include "system/log.hpp"
#include "train/engine.hpp"

namespace ddtool {
namespace {

struct ExportRequest {
    std::string checkpoint;
    std::string out;
    bool as_json = false;
};

ExitCode export_model(const ExportRequest& request) {
    train::engine().export_model(request.checkpoint, request.out);
    log_info("wrote " + request.out);
    if (request.as_json) {
        const Json report{
            {"command", "export"},
            {"checkpoint", request.checkpoint},
            {"files", {{"torch_script", request.out}, {"plain_weights", train::plain_weights_beside(request.out)}}}};
        std::cout << report.dump(2) << '\n';
    }
    return ExitCode::done;
}

}  // namespace

Command export_command() {
    const auto request = std::make_shared<ExportRequest>();
    return {.name = "export",
            .summary = "Writes a trained network as TorchScript, and its plain weights beside it",
            .example = "ddtool export --checkpoint out/lite/best.pt --out out/lite.pt",
            .options =
                {
                    {"--checkpoint", &request->checkpoint, "best.pt or last.pt of ddtool train", "FILE",
                     Presence::required},
                    {"--out", &request->out, "The model, MODEL.pt; plain weights go to MODEL.safetensors", "FILE",
                     Presence::required},
                    {"--json", &request->as_json, "Print JSON: what was written where"},
                },
            .run = [request](const Json& /*settings*/) { return export_model(*request); }};
}

}  // namespace ddtool

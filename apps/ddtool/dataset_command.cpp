#include <memory>

#include "commands.hpp"
#include "dataset_report.hpp"

namespace ddtool {
namespace {

struct DatasetRequest {
    std::string folder;
    std::string pictures;
    bool as_json = false;
};

ExitCode describe_dataset(const DatasetRequest& request, const Json& settings) {
    const dataset::Dataset data(request.folder, dataset::Check::checksums);
    print_dataset(data, request.as_json);
    if (!request.pictures.empty()) {
        draw_dataset(request.pictures, data, settings.at("image").get<ImageSettings>());
    }
    return ExitCode::done;
}

}  // namespace

Command dataset_command() {
    const auto request = std::make_shared<DatasetRequest>();
    return {.name = "dataset",
            .summary = "What is in a data set, and how well its labels tell the physics",
            .example = "ddtool dataset out/small",
            .settings = {{"image", ImageSettings{}}},
            .options =
                {
                    {"DIR", &request->folder, "The data set; every byte is checked", "DIR", Presence::required},
                    {"--pictures", &request->pictures, "Draw histograms and montages of the images there", "DIR"},
                    {"--json", &request->as_json, "Print JSON instead of tables"},
                },
            .run = [request](const Json& settings) { return describe_dataset(*request, settings); }};
}

}  // namespace ddtool

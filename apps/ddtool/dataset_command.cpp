#include "dataset_command.hpp"

#include "dataset_report.hpp"

namespace ddtool {

DatasetCommand::DatasetCommand()
    : Command("dataset", "What is in a data set, and how well its labels tell the physics",
              "ddtool dataset out/small") {}

void DatasetCommand::add_options(CLI::App& app) {
    app.add_option("DIR", folder_, "The data set; every byte is checked")->type_name("DIR")->required();
    app.add_option("--pictures", pictures_, "Draw histograms and montages of the images there")->type_name("DIR");
    app.add_flag("--json", as_json_, "Print JSON instead of tables");
}

Json DatasetCommand::default_settings() const { return {{"image", ImageSettings{}}}; }

ExitCode DatasetCommand::run(const Json& settings) {
    const dataset::Dataset data(folder_, dataset::Check::checksums);
    print_dataset(data, as_json_);
    if (!pictures_.empty()) {
        draw_dataset(pictures_, data, settings.at("image").get<ImageSettings>());
    }
    return ExitCode::done;
}

}  // namespace ddtool

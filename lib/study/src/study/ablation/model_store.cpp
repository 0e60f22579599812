#include "study/ablation/model_store.hpp"

#include "dataset/manifest.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "study/judge/model_scorer.hpp"
#include "system/atomic_file.hpp"
#include "system/fingerprint.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"

namespace ddtool {
DDTOOL_JSON_STRUCT(Confusion, true_positives, false_positives, false_negatives, true_negatives)
}  // namespace ddtool

namespace ddtool::ablation {

ModelStore::ModelStore(const learning::Engine& engine, std::filesystem::path data, std::filesystem::path folder,
                       Machine machine)
    : engine_(engine),
      data_folder_(std::move(data)),
      data_(data_folder_),
      folder_(made_folder(std::move(folder))),
      machine_(std::move(machine)),
      data_id_(file_fingerprint(data_folder_ / dataset::manifest_name)) {}

TrainedModel ModelStore::model_of(const learning::TrainSettings& settings) {
    const Json configuration{{"train", settings}, {"data", data_id_}};
    const std::filesystem::path folder = folder_ / Fingerprint().add(configuration.dump()).hex();
    const std::filesystem::path model = folder / "model.pt";
    const std::filesystem::path result = folder / "result.json";
    if (!std::filesystem::exists(result)) {
        train(settings, made_folder(folder));
        write_file(result, Json{{"configuration", configuration}, {"test", tested(settings, model)}}.dump(2) + "\n");
    }
    const Json json = Json::parse(read_file(result), nullptr, false);
    if (!json.is_object() || json.value("configuration", Json()) != configuration) {
        throw Error(result.string() +
                    ": expected the result of the configuration that its folder stands for; remove it");
    }
    return {model, json.at("test").at("confusion").get<Confusion>(), json.at("test").at("auc").get<double>()};
}

void ModelStore::train(const learning::TrainSettings& settings, const std::filesystem::path& folder) const {
    log_info("training " + settings.model + ", seed " + std::to_string(settings.seed) + ", in " + folder.string());
    learning::TrainRequest request;
    request.data = data_folder_;
    request.out = folder;
    request.settings = settings;
    request.device = machine_.device;
    request.threads = machine_.threads;
    request.resume = true;
    const learning::TrainResult trained = engine_.train(request);
    if (trained.interrupted) {
        throw TrainingStopped();
    }
    engine_.export_model(trained.best, folder / "model.pt");
}

Json ModelStore::tested(const learning::TrainSettings& settings, const std::filesystem::path& file) const {
    learning::RunOptions options;
    options.device = machine_.device;
    options.threads = machine_.threads;
    const detection::Detector detector = detection::detector_of(engine_.load(file, options));
    const detection::Task task{.label = learning::label_rule_of(settings), .split = learning::split_of(settings)};
    const detection::Performance performance = detection::evaluate(data_, detector, task).performance;
    return {{"confusion", performance.confusion}, {"auc", performance.auc}};
}

}  // namespace ddtool::ablation

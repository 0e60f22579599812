#include "study/ablation/model_store.hpp"

#include <limits>

#include "dataset/manifest.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "jobs/runner.hpp"
#include "study/judge/model_scorer.hpp"
#include "system/fingerprint.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"

namespace ddtool {
DDTOOL_JSON_STRUCT(Confusion, true_positives, false_positives, false_negatives, true_negatives)
}  // namespace ddtool

namespace ddtool::ablation {
namespace {

constexpr const char* model_name = "/model.pt";

Json json_of(const TrainedModel& model) { return {{"confusion", model.confusion}, {"auc", model.auc}}; }

TrainedModel model_from(const Json& json, const std::filesystem::path& file) {
    const Json& auc = json.at("auc");  // null stands for NaN, the AUC of a part that has one class only
    return {file, json.at("confusion").get<Confusion>(),
            auc.is_null() ? std::numeric_limits<double>::quiet_NaN() : auc.get<double>()};
}

}  // namespace

ModelStore::ModelStore(const train::Engine& engine, std::filesystem::path data, std::filesystem::path folder,
                       Machine machine)
    : engine_(engine),
      data_folder_(std::move(data)),
      data_(data_folder_),
      models_(made_folder(std::move(folder)), {.value_key = "test", .suffix = "/result.json"}),
      machine_(std::move(machine)),
      data_id_(file_fingerprint(data_folder_ / dataset::manifest_name)) {}

jobs::Key ModelStore::key_of(const train::TrainSettings& settings) const {
    return jobs::Key(Json{{"train", settings}, {"data", data_id_}});
}

std::optional<TrainedModel> ModelStore::find(const train::TrainSettings& settings) const {
    const jobs::Key key = key_of(settings);
    return models_.find(key, [&](const Json& json) {
        const std::filesystem::path file = models_.file(key, model_name);
        if (!std::filesystem::exists(file)) {
            throw Error(file.string() + ": not there");
        }
        return model_from(json, file);
    });
}

TrainedModel ModelStore::make(const train::TrainSettings& settings) const {
    const jobs::Key key = key_of(settings);
    const std::filesystem::path file = models_.file(key, model_name);
    run_training(settings, made_folder(file.parent_path()), file);
    const TrainedModel model = tested(settings, file);
    models_.save(key, json_of(model));
    return model;
}

void ModelStore::run_training(const train::TrainSettings& settings, const std::filesystem::path& folder,
                              const std::filesystem::path& model) const {
    log_info("training " + settings.model + ", seed " + std::to_string(settings.seed) + ", in " + folder.string());
    train::TrainRequest request;
    request.data = data_folder_;
    request.out = folder;
    request.settings = settings;
    request.device = machine_.device;
    request.threads = machine_.threads;
    request.resume = true;
    const train::TrainResult trained = engine_.train(request);
    if (trained.interrupted) {
        throw jobs::Stopped();
    }
    engine_.export_model(trained.best, model);
}

TrainedModel ModelStore::tested(const train::TrainSettings& settings, const std::filesystem::path& file) const {
    train::RunOptions options;
    options.device = machine_.device;
    options.threads = machine_.threads;
    const judge::Detector detector = judge::detector_of(engine_.load(file, options));
    const judge::Task task{.label = train::label_rule_of(settings), .split = train::split_of(settings)};
    const judge::Performance performance = judge::evaluate(data_, detector, task).performance;
    return {file, performance.confusion, performance.auc};
}

}  // namespace ddtool::ablation

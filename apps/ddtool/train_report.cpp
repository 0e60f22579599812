#include "train_report.hpp"

#include <array>

#include "report/page.hpp"
#include "study/judge/evaluation_page.hpp"
#include "study/judge/model_scorer.hpp"
#include "study/judge/pictures.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

report::Page train_page(const train::Engine& engine, const train::TrainRequest& request,
                        const train::TrainResult& result) {
    const std::filesystem::path pictures = request.out / "pictures";
    const judge::Task task{.label = train::label_rule_of(request.settings),
                           .split = train::split_of(request.settings),
                           .part = dataset::Part::validation};
    const dataset::Dataset data(request.data);
    const judge::Detector model =
        judge::detector_of(engine.load(result.best, {.device = request.device, .threads = request.threads}));
    const std::array evaluations{judge::evaluate(data, model, task)};
    judge::draw_evaluations(pictures, data, evaluations, evaluations.front());

    report::Page page("ddtool train", report::folder_name(request.out));
    page.text("Data set " + report::folder_name(request.data) +
              ". All but the curves is of the best epoch's network on " + name_of(task) +
              ", by which it was chosen; ddtool eval tells how it does on the part test.");
    page.section("Training").table(result_table(result));
    page.pictures(std::array{report::picture_of_file("Curves over the epochs", request.out / "curves.png")});
    judge::add_evaluations(page, pictures, data, evaluations, task);
    page.section("Settings").text("Made by " + program_version() + ".").values("Settings", Json(request.settings));
    return page;
}

}  // namespace

Table result_table(const train::TrainResult& result) {
    Table table({{"best epoch"}, {"of"}, {"loss", 4}, {"accuracy", 4}, {"F1", 4}, {"AUC", 4}});
    const train::EpochRecord& best = result.best_epoch;
    table.add_row({static_cast<std::int64_t>(best.epoch), static_cast<std::int64_t>(result.epochs),
                   best.validation_loss, best.validation_accuracy, best.validation_f1, best.validation_auc});
    return table;
}

Json result_json(const train::TrainRequest& request, const train::TrainResult& result) {
    return {{"command", "train"},
            {"settings", request.settings},
            {"epochs", result.epochs},
            {"best_epoch", result.best_epoch},
            {"files", {{"checkpoint", result.best}, {"folder", request.out}}}};
}

bool write_train_page(const train::Engine& engine, const train::TrainRequest& request,
                      const train::TrainResult& result) {
    return report::write_page(request.out / "report.html", [&] { return train_page(engine, request, result); });
}

}  // namespace ddtool

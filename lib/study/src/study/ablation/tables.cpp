#include "study/ablation/tables.hpp"

#include <cmath>

#include "scores/statistics.hpp"

namespace ddtool::ablation {
namespace {

constexpr const char* dash = "-";

std::string yes_or_dash(bool value) { return value ? "yes" : dash; }

void add_rule(Table& table, const RuleRow& row, const judge::Evaluation& result) {
    const double none = std::nan("");
    const judge::Performance& performance = result.performance;
    table.add_row({row.rule, dash, dash, dash, dash, none, row.swarm,
                   result.detector.label + " / " + result.detector.split, none, performance.confusion.accuracy(), none,
                   performance.confusion.f1(), none, performance.auc, row.paper.accuracy, row.paper.f1,
                   result.detector.decision});
}

}  // namespace

Table accuracy_table(const Plan& plan, const std::vector<RowResult>& results,
                     const std::vector<judge::Evaluation>& rules) {
    Table table({{"row"},
                 {"mapping"},
                 {"augmentation"},
                 {"loss"},
                 {"optimizer"},
                 {"epochs"},
                 {"swarm"},
                 {"trained on"},
                 {"seeds"},
                 {"accuracy"},
                 {"sd"},
                 {"F1"},
                 {"F1 sd"},
                 {"AUC"},
                 {"paper accuracy"},
                 {"paper F1"},
                 {"note"}});
    for (std::size_t index = 0; index < plan.rows.size(); ++index) {
        const Row& row = plan.rows[index];
        const train::TrainSettings& settings = row.settings;
        std::vector<double> accuracy;
        std::vector<double> f1;
        std::vector<double> auc;
        for (const TrainedModel& model : results[index].models) {
            accuracy.push_back(model.confusion.accuracy());
            f1.push_back(model.confusion.f1());
            auc.push_back(model.auc);
        }
        table.add_row({row.name, yes_or_dash(settings.image.linear_mapping),
                       yes_or_dash(settings.image.gaussian_augmentation), settings.loss, settings.optimizer.name,
                       static_cast<std::int64_t>(settings.epochs), swarm_names[dataset::index_of(settings.image.swarm)],
                       settings.label + " / " + settings.split, static_cast<std::int64_t>(accuracy.size()),
                       mean_and_sd(accuracy).mean, mean_and_sd(accuracy).sd, mean_and_sd(f1).mean, mean_and_sd(f1).sd,
                       mean_and_sd(auc).mean, row.paper.accuracy, row.paper.f1, results[index].failure});
    }
    for (std::size_t index = 0; index < plan.rules.size(); ++index) {
        add_rule(table, plan.rules[index], rules[index]);
    }
    return table;
}

Table timing_table(const Plan& plan, const std::vector<TimingResult>& results) {
    Table table({{"row"}, {"device"}, {"image matrix"}, {"time [ms]", 2}, {"paper [ms]", 0}, {"note"}});
    for (std::size_t index = 0; index < plan.timings.size(); ++index) {
        const Timing& timing = plan.timings[index];
        table.add_row({plan.rows[timing.row].name, timing.device, yes_or_dash(!timing.image_file),
                       results[index].time_ms, timing.paper_ms, results[index].failure});
    }
    return table;
}

}  // namespace ddtool::ablation

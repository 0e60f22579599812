#include "study/judge/tables.hpp"

#include <limits>
#include <map>
#include <set>

#include "scores/statistics.hpp"
#include "study/judge/samples.hpp"

namespace ddtool::judge {
namespace {

using Columns = std::vector<Table::Column>;
using Cells = std::vector<Table::Cell>;

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// A table in which the first columns of each row identify the detector. add_detector_row() fills its rows.
Table table_of(const Columns& columns) {
    Columns all{{"model"}, {"swarm"}, {"trained on"}, {"seed"}};
    all.insert(all.end(), columns.begin(), columns.end());
    return Table(all);
}

void add_detector_row(Table& table, const Detector& detector, const Cells& cells) {
    const Table::Cell seed = detector.seed ? Table::Cell(static_cast<std::int64_t>(*detector.seed)) : missing;
    Cells all{detector.name, detector.swarm, detector.label + " / " + detector.split, seed};
    all.insert(all.end(), cells.begin(), cells.end());
    table.add_row(all);
}

Table::Cell count(std::size_t number) { return static_cast<std::int64_t>(number); }

Table reliability_table(std::span<const Evaluation> evaluations) {
    Table table = table_of({{"low"}, {"high"}, {"samples"}, {"mean degree"}, {"degenerate share"}});
    for (const Evaluation& evaluation : evaluations) {
        for (const ReliabilityBin& bin :
             evaluation.calibration ? evaluation.calibration->bins : std::vector<ReliabilityBin>{}) {
            add_detector_row(table, evaluation.detector,
                             {bin.low, bin.high, count(bin.count), bin.mean_probability, bin.positive_share});
        }
    }
    return table;
}

Table confusion_table(std::span<const Evaluation> evaluations) {
    Table table = table_of({{"true positives"}, {"false positives"}, {"false negatives"}, {"true negatives"}});
    for (const Evaluation& evaluation : evaluations) {
        const Confusion& confusion = evaluation.performance.confusion;
        add_detector_row(table, evaluation.detector,
                         {count(confusion.true_positives), count(confusion.false_positives),
                          count(confusion.false_negatives), count(confusion.true_negatives)});
    }
    return table;
}

}  // namespace

Table detector_table(std::span<const Evaluation> evaluations, const Task& task) {
    Table table = table_of(
        {{"tested on"}, {"degenerate"}, {"samples"}, {"accuracy"}, {"precision"}, {"recall"}, {"F1"}, {"AUC"}});
    for (const Evaluation& evaluation : evaluations) {
        const Confusion& confusion = evaluation.performance.confusion;
        add_detector_row(
            table, evaluation.detector,
            {name_of(task), evaluation.detector.decision, count(evaluation.performance.samples), confusion.accuracy(),
             confusion.precision(), confusion.recall(), confusion.f1(), evaluation.performance.auc});
    }
    return table;
}

Table seed_table(std::span<const Evaluation> evaluations, const Task& task) {
    std::map<std::string, std::vector<const Evaluation*>> families;
    for (const Evaluation& evaluation : evaluations) {
        if (evaluation.detector.seed) {
            families[evaluation.detector.family].push_back(&evaluation);
        }
    }
    Table table({{"model"},
                 {"swarm"},
                 {"trained on"},
                 {"tested on"},
                 {"seeds"},
                 {"accuracy", 4},
                 {"accuracy sd", 4},
                 {"F1", 4},
                 {"F1 sd", 4},
                 {"AUC", 4},
                 {"AUC sd", 4}});
    for (const auto& [family, members] : families) {
        std::set<std::uint64_t> seeds;
        for (const Evaluation* member : members) {
            seeds.insert(*member->detector.seed);
        }
        if (seeds.size() < 2 || seeds.size() < members.size()) {
            continue;
        }
        const Detector& first = members.front()->detector;
        Cells cells{first.name, first.swarm, first.label + " / " + first.split, name_of(task), count(members.size())};
        for (const auto& figure : {+[](const Performance& each) { return each.confusion.accuracy(); },
                                   +[](const Performance& each) { return each.confusion.f1(); },
                                   +[](const Performance& each) { return each.auc; }}) {
            std::vector<double> values;
            for (const Evaluation* member : members) {
                values.push_back(figure(member->performance));
            }
            const MeanAndSd over_seeds = mean_and_sd(values);
            cells.insert(cells.end(), {over_seeds.mean, over_seeds.sd});
        }
        table.add_row(cells);
    }
    return table;
}

Table calibration_table(std::span<const Evaluation> evaluations, const Task& task) {
    Table table = table_of({{"tested on"}, {"ECE", 4}, {"temperature"}, {"ECE at temperature", 4}});
    for (const Evaluation& evaluation : evaluations) {
        if (evaluation.calibration) {
            add_detector_row(table, evaluation.detector,
                             {name_of(task), evaluation.calibration->error, evaluation.calibration->temperature,
                              evaluation.calibration->error_at_temperature});
        }
    }
    return table;
}

Table physics_table(std::span<const Evaluation> evaluations) {
    Table table = table_of({{"source"}, {"samples"}, {"AUC fisher"}, {"rank correlation: weak_sd_m"}, {"information"}});
    for (const Evaluation& evaluation : evaluations) {
        for (const PhysicalAgreement& physics : evaluation.physics) {
            add_detector_row(
                table, evaluation.detector,
                {physics.source, count(physics.samples), physics.auc, physics.weak_sd_rho, physics.information_rho});
        }
    }
    return table;
}

Table group_table(const dataset::Dataset& data, std::span<const Evaluation> evaluations) {
    Table table = table_of({{"by"}, {"value"}, {"samples"}, {"degenerate"}, {"accuracy"}, {"F1"}, {"AUC"}});
    for (const Evaluation& evaluation : evaluations) {
        for (const dataset::Grouping& grouping : dataset::groupings()) {
            for (const auto& [key, places] : grouped(data, evaluation.samples, grouping)) {
                const Performance part = performance_at(evaluation, places);
                add_detector_row(table, evaluation.detector,
                                 {std::string(grouping.name), key.text, count(part.samples), part.degenerate_share,
                                  part.confusion.accuracy(), part.confusion.f1(), part.auc});
            }
        }
    }
    return table;
}

std::vector<NamedTable> evaluation_tables(const dataset::Dataset& data, std::span<const Evaluation> evaluations,
                                          const Task& task) {
    std::vector<NamedTable> tables;
    if (!evaluations.front().samples.indices.empty()) {
        tables = {{"Detectors", detector_table(evaluations, task)},
                  {"Over seeds", seed_table(evaluations, task)},
                  {"Calibration", calibration_table(evaluations, task)}};
    }
    tables.push_back({"Agreement with the physics", physics_table(evaluations)});
    tables.push_back({"By group", group_table(data, detailed(evaluations))});
    std::erase_if(tables, [](const NamedTable& each) { return each.table.empty(); });
    return tables;
}

Json evaluation_json(const dataset::Dataset& data, std::span<const Evaluation> evaluations, const Task& task) {
    return {{"label", dataset::label_rule_names[index_of(task.label)]},
            {"split", dataset::split_names[index_of(task.split)]},
            {"part", dataset::part_names[index_of(task.part)]},
            {"detectors", detector_table(evaluations, task).json()},
            {"confusion", confusion_table(evaluations).json()},
            {"seeds", seed_table(evaluations, task).json()},
            {"calibration", calibration_table(evaluations, task).json()},
            {"reliability", reliability_table(evaluations).json()},
            {"physics", physics_table(evaluations).json()},
            {"groups", group_table(data, evaluations).json()}};
}

}  // namespace ddtool::judge

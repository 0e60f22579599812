#include "dataset/description.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "dataset/grouping.hpp"
#include "scores/rank_statistics.hpp"
#include "swarm/rules.hpp"

namespace ddtool::dataset {
namespace {

using Particles = std::span<const SnapshotParticle>;

/// A quantity that may agree with the physical ratio.
struct Measure {
    const char* name;
    std::function<double(const SampleRecord&, Particles)> value;
};

const std::vector<Measure>& measures() {
    const auto dispersion = [](std::size_t weight) {
        return [weight](const SampleRecord& sample, Particles) { return sample.dispersion[weight]; };
    };
    static const std::vector<Measure> all{
        {"R, accumulated", dispersion(0)},
        {"R, increment", dispersion(1)},
        {"R, match score", dispersion(2)},
        {"R, weight", dispersion(3)},
        {"absolute swarm's spread",
         [](const SampleRecord&, Particles swarm) { return spread_m(swarm, &SnapshotParticle::pose); }},
        {"step swarm's spread",
         [](const SampleRecord&, Particles swarm) { return spread_m(swarm, &SnapshotParticle::matched_motion); }},
        {"step swarm's, of predicted", [](const SampleRecord&, Particles swarm) { return step_spread_ratio(swarm); }},
    };
    return all;
}

/// The number of samples with each label.
struct LabelCounts {
    std::int64_t samples = 0;
    std::array<std::int64_t, 2> degenerate{};  ///< for each rule
    std::array<std::int64_t, 2> unknown{};

    void add(const SampleRecord& sample) {
        ++samples;
        for (std::size_t rule = 0; rule < degenerate.size(); ++rule) {
            degenerate[rule] += sample.label[rule] == Label::degenerate ? 1 : 0;
            unknown[rule] += sample.label[rule] == Label::unknown ? 1 : 0;
        }
    }

    [[nodiscard]] double share(LabelRule rule) const {
        const std::int64_t known = samples - unknown[index_of(rule)];
        return known == 0 ? std::numeric_limits<double>::quiet_NaN()
                          : static_cast<double>(degenerate[index_of(rule)]) / static_cast<double>(known);
    }
};

void add_rows(Table& table, const char* name, const std::map<GroupKey, LabelCounts>& groups) {
    for (const auto& [key, counts] : groups) {
        table.add_row({std::string(name), key.text, counts.samples, counts.share(LabelRule::dispersion),
                       counts.share(LabelRule::fisher)});
    }
}

/// The samples whose physical ratio is known, as columns.
struct LabelledPairs {
    std::vector<bool> degenerate;  ///< according to the physical ratio (label `fisher`)
    std::vector<double> weak_sd_m;
    std::vector<std::vector<double>> measured = std::vector<std::vector<double>>(measures().size());
    std::int64_t labelled = 0;  ///< number of samples that have both labels
    std::int64_t same = 0;

    void add(const SampleRecord& sample, Particles swarm) {
        degenerate.push_back(sample.label_of(LabelRule::fisher) == Label::degenerate);
        weak_sd_m.push_back(sample.weak_sd_m);
        for (std::size_t measure = 0; measure < measures().size(); ++measure) {
            measured[measure].push_back(measures()[measure].value(sample, swarm));
        }
        labelled += sample.label_of(LabelRule::fisher) != Label::unknown ? 1 : 0;
        same += sample.label[0] == sample.label[1] ? 1 : 0;
    }
};

}  // namespace

double physical_ratio(const SampleRecord& sample) { return sample.weak_sd_m / sample.odometry_sd_m; }

Table class_table(const Counts& counts) {
    Table table({{"label"}, {"split"}, {"part"}, {class_names[1]}, {class_names[0]}});
    for (const LabelRule rule : all_label_rules) {
        for (const Split split : all_splits) {
            for (const Part part : used_parts) {
                const ClassCounts& chosen = counts.of(rule).of(split, part);
                table.add_row({name_of(rule), name_of(split), name_of(part),
                               static_cast<std::int64_t>(chosen.degenerate),
                               static_cast<std::int64_t>(chosen.not_degenerate)});
            }
        }
    }
    return table;
}

Table group_table(const Dataset& data) {
    std::vector<std::map<GroupKey, LabelCounts>> groups(groupings().size());
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        for (std::size_t grouping = 0; grouping < groups.size(); ++grouping) {
            groups[grouping][groupings()[grouping].key(sample, data.run_of(sample))].add(sample);
        }
    }
    Table table({{"by"}, {"value"}, {"samples"}, {"degenerate: dispersion", 2}, {"degenerate: fisher", 2}});
    for (std::size_t grouping = 0; grouping < groups.size(); ++grouping) {
        add_rows(table, groupings()[grouping].name, groups[grouping]);
    }
    return table;
}

Table agreement_table(const Dataset& data) {
    std::map<SourceKind, LabelledPairs> by_kind;
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        if (!std::isnan(physical_ratio(sample))) {
            by_kind[data.manifest().sources[sample.source].kind].add(sample, data.particles(index));
        }
    }
    Table table({{"source"}, {"samples"}, {"accuracy"}, {"measure"}, {"AUC"}, {"rank correlation"}});
    for (const auto& [kind, pairs] : by_kind) {
        const auto count = static_cast<std::int64_t>(pairs.weak_sd_m.size());
        const double accuracy = static_cast<double>(pairs.same) / static_cast<double>(pairs.labelled);
        for (std::size_t measure = 0; measure < measures().size(); ++measure) {
            table.add_row({name_of(kind), count, accuracy, std::string(measures()[measure].name),
                           roc_auc(pairs.measured[measure], pairs.degenerate),
                           rank_correlation(pairs.measured[measure], pairs.weak_sd_m)});
        }
    }
    return table;
}

Json description_json(const Dataset& data) {
    return {{"samples", data.size()},
            {"counts", data.manifest().counts},
            {"groups", group_table(data).json()},
            {"agreement", agreement_table(data).json()}};
}

}  // namespace ddtool::dataset

#include "study/judge/label_noise.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "dataset/grouping.hpp"
#include "scores/statistics.hpp"

namespace ddtool::judge {
namespace {

using dataset::Dataset;
using dataset::Label;
using dataset::LabelRule;
using dataset::RunEntry;
using dataset::SampleRecord;

/// The labelled samples of one run, sorted by time.
struct Timeline {
    std::vector<const SampleRecord*> samples;
    double tolerance_ns = 0.0;

    void finish() {
        std::sort(samples.begin(), samples.end(), [](auto* a, auto* b) { return a->stamp_ns < b->stamp_ns; });
        std::vector<double> gaps_ns;
        for (std::size_t next = 1; next < samples.size(); ++next) {
            gaps_ns.push_back(static_cast<double>(samples[next]->stamp_ns - samples[next - 1]->stamp_ns));
        }
        tolerance_ns = gaps_ns.empty() ? 0.0 : median(gaps_ns) / 2.0;
    }

    /// The sample at about that time, or null if the run has none within the tolerance.
    [[nodiscard]] const SampleRecord* at(std::int64_t stamp_ns) const {
        const auto after = std::lower_bound(samples.begin(), samples.end(), stamp_ns,
                                            [](auto* sample, std::int64_t stamp) { return sample->stamp_ns < stamp; });
        const auto distance_ns = [&](auto place) {
            return std::abs(static_cast<double>((*place)->stamp_ns - stamp_ns));
        };
        auto nearest = after;
        if (after == samples.end() || (after != samples.begin() && distance_ns(after - 1) < distance_ns(after))) {
            nearest = after - 1;
        }
        return distance_ns(nearest) <= tolerance_ns ? *nearest : nullptr;
    }
};

/// The settings that two runs must share to count as repetitions of each other.
auto settings_of(const SampleRecord& sample, const RunEntry& run) {
    return std::tuple(sample.source, run.scene, run.particles, run.lidar, run.odometry, run.update_distance_m,
                      run.update_turn_rad);
}

using RunsBySettings = std::map<decltype(settings_of(SampleRecord{}, RunEntry{})), std::map<std::uint32_t, Timeline>>;

RunsBySettings timelines(const Dataset& data, LabelRule rule) {
    RunsBySettings runs;
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        if (sample.label_of(rule) != Label::unknown) {
            runs[settings_of(sample, data.run_of(sample))][sample.run].samples.push_back(&sample);
        }
    }
    for (auto& [settings, repetitions] : runs) {
        for (auto& [run, timeline] : repetitions) {
            timeline.finish();
        }
    }
    return runs;
}

RepeatedLabel label_in_others(const SampleRecord& sample, LabelRule rule,
                              const std::map<std::uint32_t, Timeline>& repetitions) {
    RepeatedLabel label;
    label.degenerate = sample.label_of(rule) == Label::degenerate;
    for (const auto& [run, timeline] : repetitions) {
        const SampleRecord* other = run == sample.run ? nullptr : timeline.at(sample.stamp_ns);
        if (other != nullptr) {
            ++label.others;
            label.others_degenerate += other->label_of(rule) == Label::degenerate ? 1U : 0U;
        }
    }
    return label;
}

void add_noise_row(Table& table, LabelRule rule, const std::string& scene, const std::vector<RepeatedLabel>& labels) {
    const LabelNoise noise = label_noise(labels);
    table.add_row({std::string(dataset::label_rule_names[index_of(rule)]), scene,
                   static_cast<std::int64_t>(noise.samples[1]), static_cast<std::int64_t>(noise.samples[0]),
                   noise.disagreement[1], noise.disagreement[0], noise.balanced_disagreement, noise.majority_accuracy});
}

}  // namespace

std::vector<RepeatedLabel> repeated_labels(const Dataset& data, LabelRule rule) {
    std::vector<RepeatedLabel> labels;
    for (const auto& [settings, repetitions] : timelines(data, rule)) {
        for (const auto& [run, timeline] : repetitions) {
            for (const SampleRecord* sample : timeline.samples) {
                RepeatedLabel label = label_in_others(*sample, rule, repetitions);
                label.scene = dataset::scene_family(data.run_of(*sample));
                if (label.others > 0) {
                    labels.push_back(label);
                }
            }
        }
    }
    return labels;
}

LabelNoise label_noise(std::span<const RepeatedLabel> labels) {
    LabelNoise noise;
    std::array<double, 2> differing{};  // the sums over the samples of each class
    std::array<double, 2> right{};
    for (const RepeatedLabel& label : labels) {
        const std::size_t own = label.degenerate ? 1 : 0;
        const auto others = static_cast<double>(label.others);
        const auto degenerate = static_cast<double>(label.others_degenerate);
        const double same_share = (label.degenerate ? degenerate : others - degenerate) / others;
        ++noise.samples[own];
        differing[own] += 1.0 - same_share;
        right[own] += same_share > 0.5 ? 1.0 : same_share == 0.5 ? 0.5 : 0.0;
    }
    for (const std::size_t own : {0U, 1U}) {
        const auto count = static_cast<double>(noise.samples[own]);
        noise.disagreement[own] = differing[own] / count;
        noise.majority_accuracy += right[own] / count / 2.0;
    }
    noise.balanced_disagreement = (noise.disagreement[0] + noise.disagreement[1]) / 2.0;
    return noise;
}

Table label_noise_table(const Dataset& data) {
    Table table({{"label"},
                 {"scene"},
                 {"degenerate"},
                 {"not degenerate"},
                 {"disagree: degenerate"},
                 {"disagree: not degenerate"},
                 {"disagree: balanced"},
                 {"majority accuracy"}});
    for (const LabelRule rule : {LabelRule::dispersion, LabelRule::fisher}) {
        const std::vector<RepeatedLabel> all = repeated_labels(data, rule);
        std::map<std::string, std::vector<RepeatedLabel>> by_scene;
        for (const RepeatedLabel& label : all) {
            by_scene[label.scene].push_back(label);
        }
        for (const auto& [scene, labels] : by_scene) {
            add_noise_row(table, rule, scene, labels);
        }
        if (!all.empty()) {
            add_noise_row(table, rule, "all", all);
        }
    }
    return table;
}

}  // namespace ddtool::judge

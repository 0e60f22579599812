#include "dataset/selection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "ddtool/base/random.hpp"

namespace ddtool::dataset {
namespace {

enum SelectionPurpose : std::uint64_t { choice_draw = 1, split_draw = 2 };

using Indices = std::vector<std::size_t>;

/// The indices in a random order. Equal draws, however unlikely, keep the given order.
Indices shuffled(Indices indices, std::span<const SampleRecord> records, const SampleChance& chance,
                 std::uint64_t purpose) {
    std::stable_sort(indices.begin(), indices.end(), [&](std::size_t a, std::size_t b) {
        return chance.draw(purpose, records[a]) < chance.draw(purpose, records[b]);
    });
    return indices;
}

Indices chosen(std::span<const SampleRecord> records, LabelRule rule, Label label, std::size_t wanted,
               const SampleChance& chance) {
    std::vector<Indices> by_run(chance.runs());
    for (std::size_t index = 0; index < records.size(); ++index) {
        if (records[index].label_of(rule) == label) {
            by_run[records[index].run].push_back(index);
        }
    }
    std::vector<std::size_t> available(by_run.size());
    std::transform(by_run.begin(), by_run.end(), available.begin(), [](const Indices& each) { return each.size(); });
    const std::vector<std::size_t> quotas = even_quotas(available, wanted);
    Indices all;
    for (std::size_t run = 0; run < by_run.size(); ++run) {
        const Indices order = shuffled(std::move(by_run[run]), records, chance, choice_draw + 4 * index_of(rule));
        all.insert(all.end(), order.begin(), order.begin() + static_cast<std::ptrdiff_t>(quotas[run]));
    }
    return all;
}

}  // namespace

std::vector<std::size_t> even_quotas(const std::vector<std::size_t>& available, std::size_t wanted) {
    Indices poorest_first(available.size());
    std::iota(poorest_first.begin(), poorest_first.end(), 0U);
    std::stable_sort(poorest_first.begin(), poorest_first.end(),
                     [&](std::size_t a, std::size_t b) { return available[a] < available[b]; });
    std::vector<std::size_t> quotas(available.size());
    std::size_t runs_left = available.size();
    for (const std::size_t run : poorest_first) {
        quotas[run] = std::min(available[run], wanted / runs_left--);
        wanted -= quotas[run];
    }
    return quotas;
}

std::uint64_t SampleChance::draw(std::uint64_t purpose, const SampleRecord& record) const {
    return RandomStream({seed_, purpose, run_keys_[record.run], record.update})();
}

void choose_samples(std::span<SampleRecord> records, const BalanceSettings& wanted, const SampleChance& chance) {
    for (const LabelRule rule : all_label_rules) {
        for (const Label label : {Label::not_degenerate, Label::degenerate}) {
            const std::size_t count = label == Label::degenerate ? wanted.degenerate : wanted.not_degenerate;
            const Indices order =
                shuffled(chosen(records, rule, label, count, chance), records, chance, split_draw + 4 * index_of(rule));
            const auto total = static_cast<double>(order.size());
            for (std::size_t place = 0; place < order.size(); ++place) {
                const auto at = static_cast<double>(place);
                records[order[place]].part[index_of(rule)][index_of(Split::paper)] =
                    at < std::round(0.6 * total)   ? Part::train
                    : at < std::round(0.8 * total) ? Part::validation
                                                   : Part::test;
            }
        }
    }
}

}  // namespace ddtool::dataset

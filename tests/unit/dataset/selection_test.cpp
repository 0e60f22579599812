#include "dataset/selection.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>

#include "ddtool/base/random.hpp"

namespace ddtool::dataset {
namespace {

using testing::ElementsAre;

/// Records of several runs with random labels.
std::vector<SampleRecord> drawn_records(std::uint64_t seed, std::size_t runs, std::size_t count) {
    RandomStream random({seed});
    std::vector<SampleRecord> records(count);
    for (std::size_t index = 0; index < count; ++index) {
        records[index].update = index;
        records[index].run = static_cast<std::uint32_t>(random.index(runs));
        records[index].label = {static_cast<Label>(random.index(2)),
                                static_cast<Label>(static_cast<int>(random.index(3)) - 1)};
    }
    return records;
}

SampleChance chance_for(std::size_t runs) {
    std::vector<std::uint64_t> keys(runs);
    std::iota(keys.begin(), keys.end(), 100U);
    return {1, keys};
}

std::size_t count(const std::vector<SampleRecord>& records, LabelRule rule, Label label, Part part) {
    return static_cast<std::size_t>(std::count_if(records.begin(), records.end(), [&](const SampleRecord& record) {
        return record.label_of(rule) == label && record.part_of(rule, Split::paper) == part;
    }));
}

TEST(EvenQuotas, TakeAllOfThePoorAndTheSameOfTheOthers) {
    EXPECT_THAT(even_quotas({100, 2, 100, 0}, 22), ElementsAre(10, 2, 10, 0));
    EXPECT_THAT(even_quotas({3, 4}, 100), ElementsAre(3, 4));
    EXPECT_THAT(even_quotas({9, 9}, 0), ElementsAre(0, 0));
    EXPECT_THAT(even_quotas({}, 5), ElementsAre());
}

TEST(EvenQuotas, AddUpAndDifferByOneAtMost) {
    RandomStream random({3});
    for (int round = 0; round < 50; ++round) {
        std::vector<std::size_t> available(12);
        std::generate(available.begin(), available.end(), [&] { return random.index(30); });
        const std::size_t all = std::accumulate(available.begin(), available.end(), std::size_t{0});
        const std::size_t wanted = random.index(200);
        const std::vector<std::size_t> quotas = even_quotas(available, wanted);
        EXPECT_EQ(std::accumulate(quotas.begin(), quotas.end(), std::size_t{0}), std::min(all, wanted));
        std::vector<std::size_t> limited;  // the runs that the quota limits, not the number of their samples
        for (std::size_t run = 0; run < quotas.size(); ++run) {
            EXPECT_LE(quotas[run], available[run]);
            if (quotas[run] < available[run]) {
                limited.push_back(quotas[run]);
            }
        }
        if (!limited.empty()) {
            const auto [least, most] = std::minmax_element(limited.begin(), limited.end());
            EXPECT_LE(*most - *least, 1U);
            EXPECT_LE(*std::max_element(quotas.begin(), quotas.end()), *most + 1);
        }
    }
}

TEST(ChooseSamples, GivesWhatIsWantedSixToTwoToTwo) {
    std::vector<SampleRecord> records = drawn_records(1, 10, 2000);
    choose_samples(records, {.degenerate = 200, .not_degenerate = 100}, chance_for(10));
    for (const LabelRule rule : {LabelRule::dispersion, LabelRule::fisher}) {
        EXPECT_EQ(count(records, rule, Label::degenerate, Part::train), 120U);
        EXPECT_EQ(count(records, rule, Label::degenerate, Part::validation), 40U);
        EXPECT_EQ(count(records, rule, Label::degenerate, Part::test), 40U);
        EXPECT_EQ(count(records, rule, Label::not_degenerate, Part::train), 60U);
        EXPECT_EQ(count(records, rule, Label::unknown, Part::unused),
                  static_cast<std::size_t>(std::count_if(records.begin(), records.end(), [&](const auto& record) {
                      return record.label_of(rule) == Label::unknown;
                  })));
    }
}

TEST(ChooseSamples, TakesAllOfAClassThatHasTooFew) {
    std::vector<SampleRecord> records = drawn_records(2, 3, 50);
    choose_samples(records, {.degenerate = 1000, .not_degenerate = 1}, chance_for(3));
    EXPECT_EQ(count(records, LabelRule::dispersion, Label::degenerate, Part::unused), 0U);
    EXPECT_EQ(count(records, LabelRule::dispersion, Label::not_degenerate, Part::train), 1U);
}

TEST(ChooseSamples, DoesNotDependOnTheOrderOfTheRecords) {
    std::vector<SampleRecord> records = drawn_records(3, 5, 300);
    std::vector<SampleRecord> reversed(records.rbegin(), records.rend());
    choose_samples(records, {.degenerate = 50, .not_degenerate = 40}, chance_for(5));
    choose_samples(reversed, {.degenerate = 50, .not_degenerate = 40}, chance_for(5));
    for (std::size_t index = 0; index < records.size(); ++index) {
        EXPECT_EQ(records[index].part, reversed[records.size() - 1 - index].part);
    }
}

}  // namespace
}  // namespace ddtool::dataset

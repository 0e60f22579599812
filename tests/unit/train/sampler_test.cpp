#include "train/sampler.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "thrown_text.hpp"

namespace ddtool::train {
namespace {

using Samples = std::vector<std::size_t>;

/// Sample numbers with gaps, like those of a part of a split.
Samples samples_of(std::size_t count) {
    Samples samples(count);
    std::iota(samples.begin(), samples.end(), 0U);
    std::transform(samples.begin(), samples.end(), samples.begin(), [](std::size_t each) { return 3 * each + 5; });
    return samples;
}

Samples joined(const std::vector<Samples>& batches) {
    Samples all;
    for (const Samples& batch : batches) {
        all.insert(all.end(), batch.begin(), batch.end());
    }
    return all;
}

/// The batches of all ranks, joined step by step.
std::vector<Samples> of_all_ranks(std::size_t samples, std::size_t batch_size, std::size_t ranks) {
    std::vector<Samples> global;
    for (std::size_t rank = 0; rank < ranks; ++rank) {
        const EpochPlan plan = training_epoch(samples_of(samples), batch_size, {rank, ranks}, 7, 2);
        global.resize(plan.batches.size());
        for (std::size_t step = 0; step < plan.batches.size(); ++step) {
            global[step].insert(global[step].end(), plan.batches[step].begin(), plan.batches[step].end());
        }
    }
    return global;
}

TEST(TrainingEpoch, SeveralRanksSeeWhatOneWithALargerBatchSees) {
    for (const std::size_t samples : {4U, 7U, 24U, 100U, 101U}) {
        for (const std::size_t ranks : {2U, 3U, 4U}) {
            EXPECT_EQ(of_all_ranks(samples, 4, ranks), of_all_ranks(samples, 4 * ranks, 1)) << samples << ", " << ranks;
        }
    }
}

TEST(TrainingEpoch, ShowsNoSampleTwiceAndLeavesOutLessThanABatch) {
    for (const std::size_t count : {1U, 9U, 10U, 11U, 57U}) {
        const Samples all = samples_of(count);
        const Samples seen = joined(training_epoch(all, 10, {}, 1, 0).batches);
        const std::set<std::size_t> different(seen.begin(), seen.end());
        EXPECT_EQ(different.size(), seen.size());
        EXPECT_EQ(seen.size(), count < 10 ? count : count - count % 10);
        EXPECT_TRUE(std::includes(all.begin(), all.end(), different.begin(), different.end()));
    }
}

TEST(TrainingEpoch, GivesEveryRankItsShareOfTooFewSamples) {
    for (std::size_t rank = 0; rank < 3; ++rank) {
        const EpochPlan plan = training_epoch(samples_of(8), 10, {rank, 3}, 1, 0);
        ASSERT_EQ(plan.batches.size(), 1U);
        EXPECT_THAT(plan.batches[0].size(), testing::AnyOf(2U, 3U));
    }
}

TEST(TrainingEpoch, RefusesARankWithoutASample) {
    EXPECT_EQ(ddtool::test::thrown_text<UsageError>([] {
                  training_epoch(samples_of(2), 1, {0, 3}, 1, 0);
              }),
              "training: 2 samples, expected one or more for each of 3 ranks");
    EXPECT_NE(ddtool::test::thrown_text<UsageError>([] { training_epoch({}, 1, {}, 1, 0); }), "");
}

TEST(TrainingEpoch, HasAnOrderOfItsOwnForSeedAndEpoch) {
    std::set<Samples> orders;
    for (const std::uint64_t seed : {1U, 2U}) {
        for (const std::uint64_t epoch : {0U, 1U, 2U}) {
            const EpochPlan plan = training_epoch(samples_of(50), 10, {}, seed, epoch);
            EXPECT_EQ(plan.batches, training_epoch(samples_of(50), 10, {}, seed, epoch).batches);
            EXPECT_EQ(plan.seed, seed);
            EXPECT_EQ(plan.epoch, epoch);
            orders.insert(joined(plan.batches));
        }
    }
    EXPECT_EQ(orders.size(), 6U);
}

TEST(TrainingEpoch, LeavesEverySampleOutAsOftenAsAnother) {
    const Samples all = samples_of(10);
    std::vector<int> left_out(10, 0);
    for (std::uint64_t epoch = 0; epoch < 2000; ++epoch) {
        const Samples seen = joined(training_epoch(all, 6, {}, 3, epoch).batches);
        for (std::size_t index = 0; index < all.size(); ++index) {
            left_out[index] += std::count(seen.begin(), seen.end(), all[index]) == 0 ? 1 : 0;
        }
    }
    // The distribution is binomial with p = 0.4, whose standard deviation is 22. The bounds are five of them.
    EXPECT_THAT(left_out, testing::Each(testing::AllOf(testing::Gt(690), testing::Lt(910))));
}

TEST(EvaluationPass, KeepsAllInOrder) {
    for (const std::size_t count : {0U, 1U, 9U, 10U, 11U, 57U}) {
        const EpochPlan plan = evaluation_pass(samples_of(count), 10);
        EXPECT_EQ(joined(plan.batches), samples_of(count));
        EXPECT_EQ(plan.batches.size(), (count + 9) / 10);
        EXPECT_TRUE(std::all_of(plan.batches.begin(), plan.batches.end(),
                                [](const Samples& batch) { return !batch.empty() && batch.size() <= 10; }));
    }
}

}  // namespace
}  // namespace ddtool::train

#include "train/batch_loader.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <chrono>
#include <numeric>
#include <thread>

#include "ddtool/base/error.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "swarm_dataset.hpp"
#include "thrown_text.hpp"

namespace ddtool::train {
namespace {

using test::SwarmDataset;

constexpr std::size_t sample_count = 30;

std::vector<std::size_t> all_samples() {
    std::vector<std::size_t> samples(sample_count);
    std::iota(samples.begin(), samples.end(), 0U);
    return samples;
}

const TrainSettings& small_images() {
    static const TrainSettings settings{.image = {.swarm = Swarm::step, .size_px = 32}};
    return settings;
}

class BatchLoaderTest : public ::testing::Test {
protected:
    [[nodiscard]] std::vector<Batch> load(const EpochPlan& plan, const AugmentationSettings* augmentation,
                                          std::size_t first_step = 0) const {
        BatchLoader loader(dataset_.data(), plan, small_images(), augmentation, first_step);
        std::vector<Batch> batches;
        for (Batch batch; loader.next(batch);) {
            batches.push_back(batch);
        }
        return batches;
    }

    SwarmDataset dataset_{sample_count};
    AugmentationSettings augmentation_;
};

void append(Batch& batch, const Batch& more) {
    batch.size_px = more.size_px;
    batch.images.insert(batch.images.end(), more.images.begin(), more.images.end());
    batch.classes.insert(batch.classes.end(), more.classes.begin(), more.classes.end());
}

void expect_same(const std::vector<Batch>& actual, const std::vector<Batch>& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t step = 0; step < actual.size(); ++step) {
        EXPECT_EQ(actual[step].size_px, expected[step].size_px);
        EXPECT_EQ(actual[step].classes, expected[step].classes) << step;
        EXPECT_TRUE(actual[step].images == expected[step].images) << step;
    }
}

TEST_F(BatchLoaderTest, GivesTheImagesThatTheRendererDraws) {
    const std::vector<Batch> batches = load(evaluation_pass(all_samples(), 7), nullptr);
    ASSERT_EQ(batches.size(), 5U);
    ParticleRenderer renderer(small_images().image);
    std::vector<float> image(batches[0].size_px * batches[0].size_px);
    for (const std::size_t sample : all_samples()) {
        const Batch& batch = batches[sample / 7];
        EXPECT_EQ(batch.size_px, 32U);
        EXPECT_EQ(batch.images.size(), batch.classes.size() * image.size());
        renderer.render(dataset_.data().particles(sample), std::span(image));
        EXPECT_TRUE(std::equal(image.begin(), image.end(),
                               batch.images.begin() + static_cast<std::ptrdiff_t>(sample % 7 * image.size())));
        EXPECT_EQ(batch.classes[sample % 7], sample % 3 == 0 ? 1 : 0);
    }
}

TEST_F(BatchLoaderTest, GoesOnWhereAnInterruptedEpochEnded) {
    const EpochPlan plan = training_epoch(all_samples(), 4, {}, 1, 3);
    const std::vector<Batch> whole = load(plan, &augmentation_);
    for (std::size_t first = 0; first <= whole.size(); ++first) {
        expect_same(load(plan, &augmentation_, first),
                    {whole.begin() + static_cast<std::ptrdiff_t>(first), whole.end()});
    }
}

TEST_F(BatchLoaderTest, GivesTwoRanksTheHalvesOfALargerBatch) {
    const std::vector<Batch> one = load(training_epoch(all_samples(), 6, {}, 1, 3), &augmentation_);
    std::vector<Batch> joined = load(training_epoch(all_samples(), 3, {0, 2}, 1, 3), &augmentation_);
    const std::vector<Batch> second = load(training_epoch(all_samples(), 3, {1, 2}, 1, 3), &augmentation_);
    ASSERT_EQ(joined.size(), second.size());
    for (std::size_t step = 0; step < joined.size(); ++step) {
        append(joined[step], second[step]);
    }
    expect_same(joined, one);
}

TEST_F(BatchLoaderTest, ShowsASampleInAnotherWayInEveryEpoch) {
    EpochPlan plan = evaluation_pass({4}, 1);
    std::vector<std::vector<float>> ways;
    for (const auto& [seed, epoch] : std::vector<std::pair<std::uint64_t, std::uint64_t>>{{1, 0}, {1, 1}, {2, 0}}) {
        plan.seed = seed;
        plan.epoch = epoch;
        ways.push_back(load(plan, &augmentation_).at(0).images);
    }
    ways.push_back(load(plan, nullptr).at(0).images);
    for (std::size_t one = 0; one < ways.size(); ++one) {
        for (std::size_t other = 0; other < one; ++other) {
            EXPECT_FALSE(ways[one] == ways[other]) << one << ", " << other;
        }
    }
}

TEST(BatchLoader, ChangesEverySampleInItsOwnWay) {
    const SwarmDataset dataset(2, {.alike = true});
    const AugmentationSettings augmentation{.resample_particles = false};
    for (const bool augmented : {false, true}) {
        BatchLoader loader(dataset.data(), evaluation_pass({0, 1}, 2), small_images(),
                           augmented ? &augmentation : nullptr);
        Batch batch;
        ASSERT_TRUE(loader.next(batch));
        const auto second = batch.images.begin() + static_cast<std::ptrdiff_t>(batch.images.size() / 2);
        EXPECT_EQ(std::equal(batch.images.begin(), second, second), !augmented);
    }
}

TEST_F(BatchLoaderTest, StaysAtTheEnd) {
    BatchLoader loader(dataset_.data(), evaluation_pass(all_samples(), 30), small_images(), nullptr);
    Batch batch;
    EXPECT_TRUE(loader.next(batch));
    EXPECT_FALSE(loader.next(batch));
    EXPECT_FALSE(loader.next(batch));
}

TEST(BatchLoader, TellsOfASampleWithoutALabelAfterTheBatchesBeforeIt) {
    const SwarmDataset dataset(sample_count, {.unlabelled = 17});
    BatchLoader loader(dataset.data(), evaluation_pass(all_samples(), 5), small_images(), nullptr);
    Batch batch;
    for (int step = 0; step < 3; ++step) {
        EXPECT_TRUE(loader.next(batch));
    }
    for (int again = 0; again < 2; ++again) {
        EXPECT_EQ(ddtool::test::thrown_text([&] { loader.next(batch); }), "data set: sample 17 has no label 'fisher'");
    }
}

TEST_F(BatchLoaderTest, EndsWheneverItIsNoLongerWanted) {
    // The loader is destroyed before, while and after its queue is filled, and in the middle of the epoch.
    for (int round = 0; round < 60; ++round) {
        BatchLoader loader(dataset_.data(), evaluation_pass(all_samples(), 1), small_images(), &augmentation_);
        std::this_thread::sleep_for(std::chrono::microseconds(50 * (round % 20)));
        Batch batch;
        for (int taken = 0; taken < round / 20; ++taken) {
            EXPECT_TRUE(loader.next(batch));
        }
    }
}

}  // namespace
}  // namespace ddtool::train

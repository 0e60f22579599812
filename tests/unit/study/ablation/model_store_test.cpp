#include "study/ablation/model_store.hpp"

#include <gmock/gmock.h>

#include "fake_engine.hpp"
#include "known_dataset.hpp"

namespace ddtool::ablation {
namespace {

using ddtool::test::KnownDataset;

class ModelStoreTest : public ::testing::Test {
protected:
    [[nodiscard]] ModelStore store() const { return {engine_, known_.folder(), folder_ / "runs", {}}; }

    KnownDataset known_;
    ddtool::test::TemporaryFolder folder_;
    test::FakeEngine engine_;
};

TEST_F(ModelStoreTest, TrainsATrainingOnce) {
    learning::TrainSettings settings;
    const TrainedModel first = store().model_of(settings);
    const TrainedModel again = store().model_of(settings);
    EXPECT_EQ(engine_.trainings, 1U);
    EXPECT_EQ(again.file, first.file);
    EXPECT_EQ(again.confusion, first.confusion);
    EXPECT_EQ(first.confusion.recall(), 1.0) << "seed 1 says degenerate of all";
    EXPECT_EQ(first.confusion.count(), KnownDataset::of_world / 4);
    settings.seed = 2;
    EXPECT_EQ(store().model_of(settings).confusion.recall(), 0.0);
    EXPECT_EQ(engine_.trainings, 2U);
}

TEST_F(ModelStoreTest, GoesOnAfterAStop) {
    const learning::TrainSettings settings;
    engine_.stop = true;
    EXPECT_THROW(store().model_of(settings), TrainingStopped);
    engine_.stop = false;
    EXPECT_EQ(store().model_of(settings).confusion.recall(), 1.0);
    EXPECT_EQ(engine_.trainings, 2U);
}

}  // namespace
}  // namespace ddtool::ablation

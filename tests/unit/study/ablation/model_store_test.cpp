#include "study/ablation/model_store.hpp"

#include <gmock/gmock.h>

#include "fake_engine.hpp"
#include "jobs/runner.hpp"
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

TEST_F(ModelStoreTest, FindsWhatWasTrained) {
    train::TrainSettings settings;
    EXPECT_FALSE(store().find(settings));
    const TrainedModel first = store().make(settings);
    const auto again = store().find(settings);
    ASSERT_TRUE(again);
    EXPECT_EQ(engine_.trainings, 1U);
    EXPECT_EQ(again->file, first.file);
    EXPECT_EQ(again->confusion, first.confusion);
    EXPECT_EQ(first.confusion.recall(), 1.0) << "seed 1 says degenerate of all";
    EXPECT_EQ(first.confusion.count(), KnownDataset::of_world / 4);
    settings.seed = 2;
    EXPECT_FALSE(store().find(settings));
    EXPECT_EQ(store().make(settings).confusion.recall(), 0.0);
}

TEST_F(ModelStoreTest, AnEntryWithoutItsModelIsNone) {
    const train::TrainSettings settings;
    std::filesystem::remove(store().make(settings).file);
    testing::internal::CaptureStderr();
    EXPECT_FALSE(store().find(settings));
    EXPECT_THAT(testing::internal::GetCapturedStderr(), testing::HasSubstr("model.pt: not there"));
}

TEST_F(ModelStoreTest, GoesOnAfterAStop) {
    const train::TrainSettings settings;
    engine_.stop = true;
    EXPECT_THROW((void)store().make(settings), jobs::Stopped);
    EXPECT_FALSE(store().find(settings));
    engine_.stop = false;
    EXPECT_EQ(store().make(settings).confusion.recall(), 1.0);
    EXPECT_EQ(engine_.trainings, 2U);
}

}  // namespace
}  // namespace ddtool::ablation

#include <gmock/gmock.h>

#include "scores/tum_file.hpp"
#include "study/compare/runner.hpp"
#include "study/compare/summary.hpp"
#include "temporary_folder.hpp"
#include "tiny_experiment.hpp"

namespace ddtool::compare {
namespace {

using ddtool::test::TemporaryFolder;

class ExternalTrajectoriesTest : public ::testing::Test {
protected:
    void SetUp() override {
        settings_["methods"].push_back(
            {{"name", "peer"}, {"kind", "external"}, {"trajectories", (folder_ / "peer-{world}-{seed}.tum").string()}});
    }

    [[nodiscard]] std::vector<Summary> summaries() const {
        const Experiment experiment = experiment_from_json(settings_);
        return summaries_of(experiment, cells_of(experiment), test::run_in(folder_ / "out", settings_).results);
    }
    /// Copies the trajectories of our filter from a run without the peer, as if another program had written them.
    void copy_filter_runs(std::size_t seeds) const {
        for (const Cell& cell : cells_of(experiment_from_json(settings_))) {
            if (cell.contestant == 1 && cell.seed < seeds) {
                write_tum(folder_ / ("peer-tiny-" + std::to_string(cell.seed + 1) + ".tum"),
                          ResultStore(folder_ / "out").estimate(cell));
            }
        }
    }

    TemporaryFolder folder_;
    Json settings_ = test::tiny_settings(ddtool::test::write_tiny_world(folder_ / "tiny.json"));
};

TEST_F(ExternalTrajectoriesTest, ScoresAsTheSameTrajectoryOfOurOwn) {
    EXPECT_EQ(main_summary(summaries(), 0, 2)->failed, 3U);
    copy_filter_runs(3);
    const std::vector<Summary> after = summaries();
    EXPECT_EQ(main_summary(after, 0, 2)->failed, 0U);
    for (std::size_t seed = 0; seed < 3; ++seed) {
        EXPECT_NEAR(main_summary(after, 0, 2)->values[seed], main_summary(after, 0, 1)->values[seed], 1e-6);
    }
}

TEST_F(ExternalTrajectoriesTest, IsScoredAnewWhenItsFilesChange) {
    test::run_in(folder_ / "out", settings_);
    copy_filter_runs(1);
    EXPECT_EQ(test::run_in(folder_ / "out", settings_).computed, 3U);  // two trajectories are still missing
    EXPECT_EQ(test::run_in(folder_ / "out", settings_).computed, 2U);
    std::filesystem::copy_file(folder_ / "peer-tiny-1.tum", folder_ / "peer-tiny-2.tum");
    EXPECT_EQ(test::run_in(folder_ / "out", settings_).computed, 2U);
}

TEST_F(ExternalTrajectoriesTest, IsLeftOutIfItIsOptionalAndHasNoFile) {
    settings_["methods"].back()["optional"] = true;
    EXPECT_EQ(experiment_from_json(settings_).contestants.size(), 2U);
    test::run_in(folder_ / "out", settings_);
    settings_["methods"].back()["optional"] = false;
    copy_filter_runs(1);
    settings_["methods"].back()["optional"] = true;
    ASSERT_EQ(experiment_from_json(settings_).contestants.size(), 3U);
    EXPECT_EQ(main_summary(summaries(), 0, 2)->failed, 2U);
}

}  // namespace
}  // namespace ddtool::compare

#include "study/compare/runner.hpp"

#include <gmock/gmock.h>

#include "study/compare/report.hpp"
#include "study/compare/world_pictures.hpp"
#include "temporary_folder.hpp"
#include "tiny_experiment.hpp"

namespace ddtool::compare {
namespace {

using ddtool::test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class RunTest : public ::testing::Test {
protected:
    [[nodiscard]] Json report(const std::string& name, std::size_t threads) const {
        const Experiment experiment = experiment_from_json(settings_);
        return results_json(experiment, cells_of(experiment), test::run_in(folder_ / name, settings_, threads).results);
    }

    TemporaryFolder folder_;
    Json settings_ = test::tiny_settings(ddtool::test::write_tiny_world(folder_ / "tiny.json"));
};

TEST_F(RunTest, GivesTheSameReportOnOneThreadAndOnTwo) {
    const Json on_one = report("one", 1);
    EXPECT_EQ(on_one["rows"].size(), 6U);  // three kinds of error for two methods
    EXPECT_THAT(on_one["failures"], IsEmpty());
    EXPECT_EQ(on_one.dump(), report("two", 2).dump());
}

TEST_F(RunTest, ShowsAFailedRunWithItsReasonAndGoesOn) {
    settings_["worlds"].push_back({{"name", "lost"}, {"log", (folder_ / "lost.mcap").string()}});
    const RunOutcome outcome = test::run_in(folder_ / "out", settings_);
    const auto cells = cells_of(experiment_from_json(settings_));
    for (std::size_t index = 0; index < cells.size(); ++index) {
        const std::string& failure = outcome.results[index].failure;
        if (cells[index].world == 1) {
            EXPECT_THAT(failure, HasSubstr("lost.mcap"));
        } else {
            EXPECT_EQ(failure, "");
        }
    }
    const Json table = report("out", 1);
    EXPECT_EQ(table["failures"].size(), 6U);
    EXPECT_THAT(table["failures"][0]["why"].get<std::string>(), HasSubstr("lost.mcap"));
}

TEST_F(RunTest, RunsEqualCellsOnce) {
    settings_["methods"].push_back(settings_["methods"][1]);
    settings_["methods"][2]["name"] = "the same again";
    const RunOutcome outcome = test::run_in(folder_ / "out", settings_, 2);
    EXPECT_EQ(outcome.results.size(), 9U);
    EXPECT_EQ(outcome.computed, 6U);
    EXPECT_EQ(Json(outcome.results[1].score), Json(outcome.results[2].score));
}

TEST_F(RunTest, DrawsThePicturesThatTheReportNames) {
    const Experiment experiment = experiment_from_json(settings_);
    const auto cells = cells_of(experiment);
    ResultStore store(folder_ / "out");
    ThreadPool threads(1);
    const auto results = run_cells(experiment, cells, store, threads, "this build").results;
    const auto pictures = draw_worlds(folder_ / "out", experiment, cells, results, store, threads);
    write_report(folder_ / "out", experiment, cells, results, pictures);
    std::ifstream file(folder_ / "out/results.md");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    EXPECT_THAT(text, HasSubstr("too few seeds for the number of tests (1); 6 are the fewest"));
    EXPECT_EQ(pictures.size(), 3U);
    for (const Picture& picture : pictures) {
        EXPECT_GT(std::filesystem::file_size(folder_ / ("out/" + picture.file)), 1000U);
        EXPECT_THAT(text, HasSubstr("(" + picture.file + ")"));
    }
}

}  // namespace
}  // namespace ddtool::compare

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <chrono>
#include <thread>

#include "scores/tum_file.hpp"
#include "study/compare/runner.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"
#include "tiny_experiment.hpp"

namespace ddtool::compare {
namespace {

using ddtool::test::TemporaryFolder;
using ddtool::test::thrown_text;
using ::testing::HasSubstr;

class ResumeTest : public ::testing::Test {
protected:
    [[nodiscard]] std::size_t finished(const std::string& name) const {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(folder_ / (name + "/cells"))) {
            count += entry.path().extension() == ".json" ? 1U : 0U;
        }
        return count;
    }

    TemporaryFolder folder_;
    Json settings_ = test::tiny_settings(ddtool::test::write_tiny_world(folder_ / "tiny.json"));
};

TEST_F(ResumeTest, ComputesNothingTheSecondTime) {
    const RunOutcome first = test::run_in(folder_ / "out", settings_);
    const RunOutcome second = test::run_in(folder_ / "out", settings_);
    EXPECT_EQ(first.computed, 6U);
    EXPECT_EQ(second.computed, 0U);
    for (std::size_t index = 0; index < first.results.size(); ++index) {
        EXPECT_EQ(second.results[index].score, first.results[index].score);
        EXPECT_EQ(second.results[index].scans, first.results[index].scans);
    }
}

TEST_F(ResumeTest, ComputesOnlyWhatIsNew) {
    test::run_in(folder_ / "out", settings_);
    settings_["seeds"]["count"] = 4U;
    EXPECT_EQ(test::run_in(folder_ / "out", settings_).computed, 2U);
    settings_["methods"][1]["filter"]["particles"] = 3U;
    EXPECT_EQ(test::run_in(folder_ / "out", settings_).computed, 4U);
}

TEST_F(ResumeTest, GoesOnAfterAKill) {
    settings_["seeds"]["count"] = 40U;
    std::filesystem::create_directories(folder_ / "cut/cells");
    const pid_t child = ::fork();
    if (child == 0) {
        test::run_in(folder_ / "cut", settings_);
        ::_exit(0);
    }
    while (finished("cut") < 3 && ::waitpid(child, nullptr, WNOHANG) == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    const std::size_t before = finished("cut");
    const RunOutcome resumed = test::run_in(folder_ / "cut", settings_);
    const RunOutcome unbroken = test::run_in(folder_ / "whole", settings_);
    EXPECT_LT(before, 80U);
    EXPECT_EQ(resumed.computed, 80U - before);
    for (std::size_t index = 0; index < unbroken.results.size(); ++index) {
        EXPECT_EQ(resumed.results[index].score, unbroken.results[index].score);
    }
}

TEST_F(ResumeTest, RefusesAResultOfAnotherConfiguration) {
    test::run_in(folder_ / "out", settings_);
    const auto cells = cells_of(experiment_from_json(settings_));
    const auto file = [&](const Cell& cell) { return folder_ / ("out/cells/" + cell.id + ".json"); };
    std::filesystem::copy_file(file(cells[0]), file(cells[1]), std::filesystem::copy_options::overwrite_existing);
    EXPECT_THAT(thrown_text([&] { test::run_in(folder_ / "out", settings_); }), HasSubstr(cells[1].id));
}

}  // namespace
}  // namespace ddtool::compare

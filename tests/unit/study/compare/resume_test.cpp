#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>
#include <csignal>

#include <chrono>
#include <thread>

#include "study/compare/runner.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "tiny_experiment.hpp"

namespace ddtool::compare {
namespace {

using ddtool::test::TemporaryFolder;

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
        EXPECT_EQ(Json(second.results[index].score), Json(first.results[index].score));
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
        EXPECT_EQ(Json(resumed.results[index].score), Json(unbroken.results[index].score));
    }
}

TEST_F(ResumeTest, MakesADamagedResultAnewAndSaysSo) {
    const RunOutcome first = test::run_in(folder_ / "out", settings_);
    const auto cells = cells_of(experiment_from_json(settings_));
    const auto file = [&](const Cell& cell, const char* suffix) {
        return folder_ / ("out/cells/" + cell.key.id() + suffix);
    };
    const auto overwrite = std::filesystem::copy_options::overwrite_existing;
    std::filesystem::copy_file(file(cells[0], ".json"), file(cells[1], ".json"), overwrite);
    write_file(file(cells[2], ".tum"), "1.0 here");
    std::filesystem::remove(file(cells[3], ".tum"));
    write_file(file(cells[4], ".json"), read_file(file(cells[4], ".json")).substr(0, 200));
    testing::internal::CaptureStderr();
    const RunOutcome second = test::run_in(folder_ / "out", settings_);
    const std::string said = testing::internal::GetCapturedStderr();
    EXPECT_EQ(second.computed, 4U);
    EXPECT_EQ(test::run_in(folder_ / "out", settings_).computed, 0U);
    for (std::size_t index = 0; index < cells.size(); ++index) {
        const bool damaged = index >= 1 && index <= 4;
        const std::string warning = file(cells[index], ".json").string() + ": damaged, so it counts as missing";
        EXPECT_EQ(said.find(warning) != std::string::npos, damaged) << said;
        EXPECT_EQ(Json(second.results[index].score), Json(first.results[index].score));
    }
}

}  // namespace
}  // namespace ddtool::compare

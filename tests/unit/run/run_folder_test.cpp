#include "run/run_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "run/run_summary.hpp"
#include "small_run.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

std::set<std::string> names_in(const std::filesystem::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        names.insert(entry.path().filename());
    }
    return names;
}

FilterRun write_run(const std::filesystem::path& place, bool with_snapshots, bool with_truth = true) {
    test::SmallRun small;
    RunFolder folder(place, with_snapshots);
    FilterRun run = small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
        folder.add(frame, update, small.filter());
        return true;
    });
    if (!with_truth) {
        run.ground_truth.clear();
    }
    folder.finish(run, map_raster(run.map));
    folder.write_json("config.json", Json::object());
    const std::set<std::string> listed(folder.files().begin(), folder.files().end());
    EXPECT_EQ(listed, names_in(place));
    return run;
}

TEST(RunFolder, HoldsNothingOfAnEarlierRun) {
    const test::TemporaryFolder folder;
    write_run(folder / "a/b", true);
    EXPECT_TRUE(std::filesystem::exists(folder / "a/b/snapshots.mcap"));
    EXPECT_TRUE(std::filesystem::exists(folder / "a/b/ground_truth.tum"));
    write_run(folder / "a/b", false, false);
    EXPECT_FALSE(std::filesystem::exists(folder / "a/b/snapshots.mcap"));
    EXPECT_FALSE(std::filesystem::exists(folder / "a/b/ground_truth.tum"));
}

TEST(RunFolder, KeepsTheEarlierRunWhenThisOneFails) {
    const test::TemporaryFolder folder;
    write_run(folder / "out", true);
    const std::set<std::string> before = names_in(folder / "out");
    const std::string log = read_file(folder / "out/result.mcap");
    {
        test::SmallRun small;
        RunFolder again(folder / "out", true);
        small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
            again.add(frame, update, small.filter());
            return false;
        });
    }
    EXPECT_EQ(names_in(folder / "out"), before);
    EXPECT_EQ(read_file(folder / "out/result.mcap"), log);
}

TEST(RunFolder, IsNamedWhereItCannotBeMade) {
    const test::TemporaryFolder folder;
    write_file(folder / "file", "");
    EXPECT_THAT(test::thrown_text([&] { RunFolder(folder / "file/out", false); }), testing::HasSubstr("file/out: "));
}

TEST(RunSummary, CountsAndScores) {
    test::SmallRun small;
    std::size_t scans = 0;
    const FilterRun run = small.run([&](const SensorFrame&, const std::optional<Update>&) { return ++scans > 0; });
    const Json report = to_run_json(run_summary(run, map_raster(run.map), {}, 0.0));
    EXPECT_EQ(report.at("scans"), scans);
    EXPECT_NEAR(report.at("path_m"), 6.0, 0.6);
    EXPECT_NEAR(report.at("map").at("width_m"), 6.0, 0.3);
    EXPECT_LT(report.at("errors").at("ate_m").at("rmse"), 0.1);
    EXPECT_GT(report.at("stages").at("match_s"), 0.0);
}

TEST(RunSummary, TellsHowLongStepsTook) {
    EXPECT_TRUE(to_run_json({}).at("step_ms").is_null());
    test::SmallRun small;
    RunCourse course;
    const FilterRun run = small.run([&](const SensorFrame&, const std::optional<Update>& update) {
        if (update) {
            course.add(*update, summary_of(*update));
        }
        return true;
    });
    const Json steps = to_run_json(run_summary(run, map_raster(run.map), course, 0.0)).at("step_ms");
    EXPECT_GT(steps.at("median"), 0.0);
    EXPECT_GE(steps.at("p99"), steps.at("median"));
    EXPECT_GE(steps.at("most"), steps.at("p99"));
}

TEST(RunSummary, HasNoErrorsWithoutTheTruth) {
    FilterRun run;
    run.trajectory = {{0, {}}};
    EXPECT_FALSE(to_run_json(run_summary(run, map_raster(run.map), {}, 0.0)).contains("errors"));
}

}  // namespace
}  // namespace ddtool

#include "bench_report.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "temporary_folder.hpp"

namespace ddtool::matcher_bench {
namespace {

using testing::HasSubstr;

/// A world that holds the robot along at 5 cm cells and a bare one.
std::vector<CaseResult> two_results() {
    CaseResult held{.world = "recesses", .lidar = usual_lidar, .cell_size_m = 0.05, .summary = {}};
    held.summary.matches = 100;
    AxisSummary& axis = held.summary.axes[along];
    axis.held = 100;
    axis.bias = {0.0023, 0.0004};
    axis.spread = 0.0078;
    axis.bound = 0.0039;
    held.summary.drift = {0.00352, 0.0001};
    CaseResult bare = held;
    bare.world = "bare";
    bare.summary.axes[along] = {};
    return {held, bare};
}

TEST(BenchReport, TablesShowMillimetresAndADashForWhatIsMissing) {
    const std::string text = tables(two_results());
    EXPECT_THAT(text, HasSubstr("2.30 ± 0.40"));
    EXPECT_THAT(text, HasSubstr("0.352 ± 0.010"));
    EXPECT_THAT(text, HasSubstr("360 x 12 m, 15 mm"));
    EXPECT_THAT(text, testing::ContainsRegex("recesses .* 7\\.80 .* 3\\.90 .* 2\\.00"));
    EXPECT_THAT(text, testing::ContainsRegex("bare .* - "));
}

TEST(BenchReport, JsonHasSiUnitsAndNullForWhatIsMissing) {
    const Json json = results_json({}, two_results());
    EXPECT_EQ(json["cases"][0]["axes"]["along"]["bias"]["mean"], 0.0023);
    EXPECT_EQ(json["cases"][0]["drift"]["mean"], 0.00352);
    EXPECT_TRUE(json["cases"][1]["axes"]["along"]["bias"]["mean"].is_null());
    EXPECT_EQ(json["matcher"]["reach_m"], ScanMatcherSettings{}.reach_m);
}

TEST(BenchReport, DrawsAPicture) {
    const test::TemporaryFolder folder;
    write_picture(folder / "bench.png", two_results());
    EXPECT_GT(std::filesystem::file_size(folder / "bench.png"), 1000U);
}

}  // namespace
}  // namespace ddtool::matcher_bench

#include "system/log.hpp"

#include <gtest/gtest.h>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

/// What appears on stderr if one line is written at each level, and `level` is the lowest one that is shown.
std::string written_at(LogLevel level) {
    set_log_level(level);
    testing::internal::CaptureStderr();
    log_debug("a {brace}");
    log_info("b");
    log_warning("c");
    log_error("d");
    set_log_level(LogLevel::info);
    return testing::internal::GetCapturedStderr();
}

TEST(Log, WritesALineForWhatIsAtTheLevelOrAbove) {
    EXPECT_EQ(written_at(LogLevel::debug),
              "ddtool: debug: a {brace}\nddtool: info: b\nddtool: warning: c\nddtool: error: d\n");
    EXPECT_EQ(written_at(LogLevel::warning), "ddtool: warning: c\nddtool: error: d\n");
    EXPECT_EQ(written_at(LogLevel::error), "ddtool: error: d\n");
}

TEST(Log, ShowsWhatItWouldWrite) {
    set_log_level(LogLevel::warning);
    EXPECT_FALSE(log_shows(LogLevel::info));
    EXPECT_TRUE(log_shows(LogLevel::warning));
    set_log_level(LogLevel::info);
    EXPECT_TRUE(log_shows(LogLevel::info));
}

TEST(Log, AHostMayTakeTheLinesThatAreShown) {
    std::string taken;
    send_log_to([&](LogLevel level, const std::string& line) {
        taken += std::to_string(static_cast<int>(level)) + line + ";";
    });
    EXPECT_EQ(written_at(LogLevel::warning), "");
    EXPECT_EQ(taken, "2c;3d;");
    send_log_to({});
    EXPECT_EQ(written_at(LogLevel::error), "ddtool: error: d\n");
}

TEST(Log, LevelsHaveNames) {
    EXPECT_EQ(log_level_named("warning"), LogLevel::warning);
    EXPECT_THROW(log_level_named("loud"), UsageError);
}

}  // namespace
}  // namespace ddtool

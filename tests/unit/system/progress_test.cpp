#include "system/progress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ddtool {
namespace {

TEST(FormatDuration, ShowsHoursOnlyWhereThereAreAny) {
    EXPECT_EQ(format_duration(0.0), "0:00");
    EXPECT_EQ(format_duration(59.4), "0:59");
    EXPECT_EQ(format_duration(59.6), "1:00");
    EXPECT_EQ(format_duration(3599.6), "1:00:00");
    EXPECT_EQ(format_duration(7389.0), "2:03:09");
}

TEST(FormatDuration, IsAQuestionMarkForWhatIsNoDuration) {
    for (const double seconds : {-1.0, 1e300, std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_EQ(format_duration(seconds), "?");
    }
}

TEST(Progress, IsSilentWhereStderrIsNoTerminal) {
    testing::internal::CaptureStderr();  // redirects stderr to a file
    {
        Progress progress("reading", "scans");
        progress.update(0.5, 10);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace ddtool

#include "system/task_progress.hpp"

#include <gmock/gmock.h>

#include "system/log.hpp"

namespace ddtool {
namespace {

using testing::HasSubstr;

TEST(TaskProgress, SaysWhatEndedAndHowManyOfAll) {
    testing::internal::CaptureStderr();
    TaskProgress progress("comparing", "runs", 3);
    progress.update(1, 0.5);
    progress.finish(1, "s2 / seed 1", "done in 0:05");
    progress.fail(0, "s2 / seed 2", "no scans");
    const std::string lines = testing::internal::GetCapturedStderr();
    EXPECT_THAT(lines, HasSubstr("s2 / seed 1: done in 0:05; 1 of 3"));
    EXPECT_THAT(lines, HasSubstr("s2 / seed 2: failed: no scans; 2 of 3"));
}

}  // namespace
}  // namespace ddtool

#include "scores/multiple_tests.hpp"

#include <gmock/gmock.h>

namespace ddtool {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(HolmAdjusted, IsTheWorkedExample) {
    // 4 x 0.01 = 0.04; 3 x 0.02 = 0.06; 2 x 0.03 = 0.06, the same; 1 x 0.05 is raised to 0.06, because the results may
    // not decrease.
    const std::vector p_values{0.03, 0.01, 0.05, 0.02};
    EXPECT_THAT(holm_adjusted(p_values), ElementsAre(0.06, 0.04, 0.06, 0.06));
}

TEST(HolmAdjusted, LeavesOneTestAloneAndStaysBelowOne) {
    EXPECT_THAT(holm_adjusted(std::vector{0.04}), ElementsAre(0.04));
    EXPECT_THAT(holm_adjusted(std::vector{0.9, 0.8}), ElementsAre(1.0, 1.0));
    EXPECT_THAT(holm_adjusted(std::vector<double>{}), IsEmpty());
}

TEST(HolmAdjusted, FollowsAPermutation) {
    const std::vector<double> adjusted = holm_adjusted(std::vector{0.001, 0.2, 0.03});
    EXPECT_THAT(holm_adjusted(std::vector{0.03, 0.001, 0.2}), ElementsAre(adjusted[2], adjusted[0], adjusted[1]));
}

}  // namespace
}  // namespace ddtool

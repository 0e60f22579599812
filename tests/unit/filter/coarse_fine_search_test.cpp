#include "ddtool/filter/coarse_fine_search.hpp"

#include <gtest/gtest.h>

#include "known_view.hpp"

namespace ddtool {
namespace {

TEST(SearchCount, IsOneMoreForEveryQuarterOfTheDegree) {
    EXPECT_EQ(search_count(0.0), 1U);
    EXPECT_EQ(search_count(0.24), 1U);
    EXPECT_EQ(search_count(0.25), 2U);
    EXPECT_EQ(search_count(0.5), 3U);
    EXPECT_EQ(search_count(0.99), 4U);
    EXPECT_EQ(search_count(1.0), 5U);
    EXPECT_EQ(search_count(1.7), 5U);
    EXPECT_EQ(search_count(-1.0), 1U);
}

TEST(CoarseFineSearch, NearsThePoseTheMoreTheHigherTheDegree) {
    KnownView view(furnished_room());
    const Pose2 start = view.pose * Pose2{0.22, -0.2, 0.11};
    const ScanMatch found = view.matcher.evaluate(view.grid, view.match_points, start);
    const auto searched = [&](double degree) {
        return CoarseFineSearch({}).correct(view.context_of_degree(degree, start), found);
    };
    EXPECT_GT(searched(0.0).score, found.score);
    EXPECT_GT(searched(1.0).score, searched(0.0).score);
    EXPECT_LT(distance_m(searched(1.0).pose, view.pose), 0.08);
}

TEST(CoarseFineSearch, LeavesTheBestPose) {
    KnownView view(furnished_room());
    const ScanMatch found = view.matcher.evaluate(view.grid, view.match_points, view.pose);
    EXPECT_EQ(CoarseFineSearch({}).correct(view.context_of_degree(1.0, view.pose), found).pose, view.pose);
}

}  // namespace
}  // namespace ddtool

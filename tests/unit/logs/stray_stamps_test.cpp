#include "logs/stream/stray_stamps.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <vector>

namespace ddtool {
namespace {

std::string found_in(const std::vector<double>& stamps_s) {
    StrayStamps strays;
    for (const double stamp_s : stamps_s) {
        strays.add(std::llround(1e9 * stamp_s), 0);
        strays.add(std::llround(1e9 * stamp_s) + 5'000'000'000'000, 1);  // another lidar with its own clock
    }
    return strays.finding();
}

TEST(StrayStamps, AreCountedWhereTheNextScanGoesOn) {
    EXPECT_EQ(found_in({1.0, 1.2, 1e8, 1.6, 1.8}),
              "2 scans are left out, stamped far away from the scans before and after, the first of them number 3, 3.2 "
              "years ahead");
    EXPECT_THAT(found_in({100.0, 100.2, 50.0, 100.6}), testing::HasSubstr("number 3, 50.2 s behind"));
    EXPECT_THAT(found_in({9e6, 1.0, 1.2}), testing::HasSubstr("number 1, 104.2 days ahead"));
    EXPECT_THAT(found_in({1.0, 500.0, 1.4, 1.6, 700.0, 1.9}), testing::HasSubstr("4 scans"));
}

TEST(StrayStamps, AreNoPausesNorClocksThatAreSet) {
    EXPECT_EQ(found_in({1.0, 1.2, 500.0, 500.2}), "");
    EXPECT_EQ(found_in({500.0, 500.2, 1.0, 1.2}), "");
    EXPECT_EQ(found_in({1.0, 1.2, 0.9, 1.4}), "");
    EXPECT_EQ(found_in({1.0}), "");
}

}  // namespace
}  // namespace ddtool

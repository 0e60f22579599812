#include "ddtool/robot/laser_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace ddtool {
namespace {

enum class Meaning { range, no_return, invalid };

struct Row {
    float raw;
    Meaning meaning;
};

constexpr float inf = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();

class NormaliseRanges : public testing::TestWithParam<Row> {};

float normalised(float raw, double range_min_m, double range_max_m) {
    LaserScan scan;
    scan.range_min_m = range_min_m;
    scan.range_max_m = range_max_m;
    scan.ranges_m = {raw};
    normalise_ranges(scan);
    return scan.ranges_m.front();
}

TEST_P(NormaliseRanges, AsTheMessageDefinitionSays) {
    const auto [raw, meaning] = GetParam();
    const float once = normalised(raw, 0.5, 8.0);
    switch (meaning) {
        case Meaning::range:
            EXPECT_EQ(once, raw);
            break;
        case Meaning::no_return:
            EXPECT_EQ(once, LaserScan::no_return);
            break;
        case Meaning::invalid:
            EXPECT_TRUE(std::isnan(once));
            break;
    }
    const float twice = normalised(once, 0.5, 8.0);
    EXPECT_TRUE(twice == once || (std::isnan(twice) && std::isnan(once)));
}

INSTANTIATE_TEST_SUITE_P(Table, NormaliseRanges,
                         testing::Values(Row{0.5F, Meaning::range}, Row{3.0F, Meaning::range},
                                         Row{8.0F, Meaning::range}, Row{8.001F, Meaning::no_return},
                                         Row{inf, Meaning::no_return}, Row{0.499F, Meaning::invalid},
                                         Row{0.0F, Meaning::invalid}, Row{-1.0F, Meaning::invalid},
                                         Row{-inf, Meaning::invalid}, Row{nan, Meaning::invalid}));

TEST(NormaliseRange, ZeroIsInvalidEvenWithoutALeastRange) { EXPECT_TRUE(std::isnan(normalised(0.0F, 0.0, 8.0))); }

TEST(LaserScan, ReversedScanPointsTheSameWays) {
    LaserScan scan;
    scan.angle_min_rad = -1.0;
    scan.angle_increment_rad = 0.5;
    LaserScan reversed;
    reversed.angle_min_rad = 1.0;
    reversed.angle_increment_rad = -0.5;
    for (std::size_t beam = 0; beam < 5; ++beam) {
        EXPECT_DOUBLE_EQ(scan.angle_rad(beam), reversed.angle_rad(4 - beam));
    }
}

}  // namespace
}  // namespace ddtool

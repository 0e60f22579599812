#include "logs/stream/no_return.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

LaserScan scan_of(std::vector<float> ranges_m, double range_max_m = 0.0) {
    LaserScan scan;
    scan.angle_increment_rad = 0.01;
    scan.range_max_m = range_max_m;
    scan.ranges_m = std::move(ranges_m);
    return scan;
}

std::vector<double> values_of(const NoReturns& found) {
    std::vector<double> values_m;
    for (const NoReturnCode& code : found.codes) {
        values_m.push_back(std::round(1e3 * code.value_m) / 1e3);
    }
    return values_m;
}

std::vector<float> echoes(double low_m, double high_m) {
    RandomStream random({3});
    std::vector<float> ranges(5000);
    for (float& range : ranges) {
        range = static_cast<float>(random.uniform(low_m, high_m));
    }
    return ranges;
}

std::vector<double> found_in(const std::vector<float>& ranges_m, bool standing_too = true) {
    RangePiles piles;
    piles.add(scan_of(ranges_m));
    return values_of(piles.find(standing_too));
}

class NoReturnValue : public testing::TestWithParam<double> {};

TEST_P(NoReturnValue, IsFoundAmongEchoes) {
    std::vector<float> ranges = echoes(0.2, 0.9 * GetParam());
    ranges.insert(ranges.begin() + 100, 700, static_cast<float>(GetParam()));
    EXPECT_THAT(found_in(ranges), ElementsAre(GetParam()));
}

// The SICK LMS in centimetre mode and in millimetre mode, and lidars with a short and with a long range.
INSTANTIATE_TEST_SUITE_P(Lidars, NoReturnValue, testing::Values(81.83, 81.91, 8.191, 5.6, 50.0));

TEST(NoReturn, RareHigherValuesDoNotHideTheUsualOne) {
    std::vector<float> ranges = echoes(0.2, 7.0);
    ranges.insert(ranges.end(), 500, 8.183F);
    ranges.insert(ranges.end(), 3, 8.290F);
    EXPECT_THAT(found_in(ranges), ElementsAre(8.183));
}

TEST(NoReturn, EachOfSeveralCodesIsFound) {
    std::vector<float> ranges = echoes(0.2, 30.0);
    for (const auto& [code_m, count] : {std::pair{32.759F, 40}, {32.763F, 90}, {32.767F, 200}}) {
        ranges.insert(ranges.end(), static_cast<std::size_t>(count), code_m);
    }
    EXPECT_THAT(found_in(ranges), ElementsAre(32.767, 32.763, 32.759));
}

TEST(NoReturn, EchoesAloneHaveNone) {
    EXPECT_THAT(found_in(echoes(0.2, 12.0)), IsEmpty());
    EXPECT_THAT(values_of(RangePiles().find(true)), IsEmpty());
}

TEST(NoReturn, AFarWallSeenAgainAndAgainIsNoCode) {
    std::vector<float> ranges = echoes(0.2, 5.0);
    for (int i = 0; i < 500; ++i) {
        ranges.push_back(20.00F + 0.01F * static_cast<float>(i % 5));
    }
    EXPECT_THAT(found_in(ranges), IsEmpty());
}

/// A lidar of 360 beams in an empty room, as it is for many that hit no wall within their reach.
struct Lidar {
    double length_m = 11.0;  ///< of the room, along x
    double width_m = 8.0;
    double resolution_m = 0.001;
    double reach_m = INFINITY;
    double code_m = 0.0;  ///< read beyond the reach
    int beams = 360;

    [[nodiscard]] LaserScan scan(double x_m, double y_m, double heading_rad) const {
        std::vector<float> ranges;
        for (int beam = 0; beam < beams; ++beam) {
            const double angle = heading_rad + beam * 2.0 * std::numbers::pi / beams;
            const double along = std::abs(((std::cos(angle) > 0.0 ? length_m : 0.0) - x_m) / std::cos(angle));
            const double across = std::abs(((std::sin(angle) > 0.0 ? width_m : 0.0) - y_m) / std::sin(angle));
            const double echo = resolution_m * std::round(std::min(along, across) / resolution_m);
            ranges.push_back(static_cast<float>(echo > reach_m ? code_m : echo));
        }
        return scan_of(ranges, std::isfinite(reach_m) ? reach_m : 30.0);
    }
};

RangePiles lap(const Lidar& lidar, int scans = 60) {
    RangePiles piles;
    for (int i = 0; i < scans; ++i) {
        const double angle = 0.05 * i;
        piles.add(lidar.scan(5.5 + 3.0 * std::cos(angle), 4.0 + 2.0 * std::sin(angle), angle));
    }
    return piles;
}

class NoReturnResolution : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Steps, NoReturnResolution, testing::Values(1e-6, 0.001, 0.01, 0.05));

TEST_P(NoReturnResolution, AMissThatReadsTheMaximumRangeIsFound) {
    const Lidar lidar{.resolution_m = GetParam(), .reach_m = 5.0, .code_m = 5.0};
    EXPECT_THAT(values_of(lap(lidar).find(false)), ElementsAre(5.0));
    RangePiles standing;
    for (int i = 0; i < 10; ++i) {
        standing.add(lidar.scan(3.0, 3.0, 0.0));
    }
    EXPECT_THAT(values_of(standing.find(false)), ElementsAre(5.0));
}

TEST_P(NoReturnResolution, TheWallsOfARoomAreNoCodes) {
    EXPECT_THAT(values_of(lap({.resolution_m = GetParam()}).find(false)), IsEmpty());
}

TEST_P(NoReturnResolution, TheWallsOfACorridorAlongTheWayAreNoCodes) {
    const Lidar lidar{.length_m = 60.0, .width_m = 2.0, .resolution_m = GetParam()};
    RangePiles piles;
    for (int i = 0; i < 200; ++i) {
        piles.add(lidar.scan(10.0 + 0.2 * i, 1.0, 0.0));
    }
    EXPECT_THAT(values_of(piles.find(false)), IsEmpty());
}

TEST_P(NoReturnResolution, TheWallsOfANarrowCorridorAreNoCodes) {
    for (const double beside_m : {0.5, 0.45}) {  // in the middle, where both walls are as far, and beside it
        const Lidar lidar{.length_m = 60.0,
                          .width_m = 1.0,
                          .resolution_m = GetParam(),
                          .reach_m = 30.0,
                          .code_m = INFINITY,
                          .beams = 1440};
        RangePiles piles;
        for (int i = 0; i < 400; ++i) {
            piles.add(lidar.scan(5.0 + 0.1 * std::max(0, i - 100), beside_m, 0.0));
        }
        EXPECT_THAT(values_of(piles.find(false)), IsEmpty()) << beside_m;
    }
}

TEST_P(NoReturnResolution, AWallBeforeARobotThatStandsIsNoCode) {
    RandomStream random({5});
    const Lidar lidar{.resolution_m = GetParam()};
    RangePiles piles;
    for (int i = 0; i < 200; ++i) {
        LaserScan scan = lidar.scan(2.0, 4.0, 0.0);
        std::fill_n(scan.ranges_m.begin() + 100, 40, 9.5F);  // the farthest that it sees, at one distance
        for (float& range : scan.ranges_m) {
            range += static_cast<float>(GetParam() * std::round(random.uniform(-0.6, 0.6)));
        }
        piles.add(scan);
    }
    EXPECT_THAT(values_of(piles.find(false)), IsEmpty());
}

TEST(NoReturn, CodesFarApartAreFoundWhereTheRobotMoves) {
    RangePiles piles;
    for (int i = 0; i < 60; ++i) {
        LaserScan scan = Lidar{.reach_m = 5.0, .code_m = 51.15}.scan(3.0 + 0.1 * i, 4.0, 0.1 * i);
        scan.ranges_m[static_cast<std::size_t>(i)] = 51.14F;
        scan.ranges_m[static_cast<std::size_t>(i) + 100] = 32.767F;
        scan.range_max_m = 80.0;
        piles.add(scan);
    }
    EXPECT_THAT(values_of(piles.find(false)), ElementsAre(51.15, 51.14, 32.767));
}

TEST(NoReturn, AmongConstantReadingsOnlyTheLargestIsBelievedWhereTheRobotStands) {
    RangePiles piles;
    for (int i = 0; i < 20; ++i) {
        piles.add(scan_of({1.0F, 2.0F, 8.191F}));
    }
    EXPECT_THAT(values_of(piles.find(true)), ElementsAre(8.191));
    EXPECT_THAT(values_of(piles.find(false)), IsEmpty());
}

TEST(NoReturn, AValueAmongTheEchoesSaysNothingOfTheBeam) {
    const Lidar lidar{.resolution_m = 0.01, .reach_m = 5.0, .code_m = 2.5};
    const NoReturns found = lap(lidar).find(false);
    ASSERT_THAT(values_of(found), ElementsAre(2.5));
    EXPECT_FALSE(found.codes[0].beyond_echoes);
    LaserScan scan = scan_of({2.49F, 2.5F, 5.0F}, 30.0);
    found.apply(scan);
    EXPECT_TRUE(std::isnan(scan.ranges_m[1]));
    EXPECT_EQ(scan.ranges_m[0], 2.49F);
    EXPECT_EQ(scan.range_max_m, 30.0);
}

TEST(NoReturn, TheRobotsOwnMastIsNoCode) {
    RangePiles piles;
    for (int i = 0; i < 60; ++i) {
        LaserScan scan = Lidar{}.scan(2.0 + 0.1 * i, 3.0, 0.1 * i);
        std::fill_n(scan.ranges_m.begin() + 175, 10, 0.45F);
        piles.add(scan);
    }
    EXPECT_THAT(values_of(piles.find(false)), IsEmpty());
}

TEST(NoReturn, CodesEndTheRangeThatWasSeen) {
    LaserScan scan = scan_of({1.0F, 5.0F, 4.999F, 5.0004F}, 30.0);
    NoReturns{.codes = {{5.0, 100, true}}, .readings = 1000}.apply(scan);
    EXPECT_THAT(scan.ranges_m, ElementsAre(1.0F, LaserScan::no_return, 4.999F, LaserScan::no_return));
    EXPECT_EQ(scan.range_max_m, 5.0);
}

TEST(NoReturn, IsSaidWithItsCount) {
    const NoReturns found{.codes = {{5.0, 100, true}}, .readings = 1000};
    EXPECT_THAT(found.lines(), ElementsAre(testing::HasSubstr("5.000 m (100 of 1000 readings, 10.0 %)")));
}

TEST(NoReturn, NamedValuesAreTakenAsTheyAreAndZeroIsNone) {
    EXPECT_THAT(values_of(named_no_returns({32.767, 5.0})), ElementsAre(32.767, 5.0));
    EXPECT_THAT(values_of(named_no_returns({0.0})), IsEmpty());
}

}  // namespace
}  // namespace ddtool

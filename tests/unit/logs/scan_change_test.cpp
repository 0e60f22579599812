#include "logs/stream/scan_change.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

LaserScan beams(std::vector<float> ranges_m) {
    LaserScan scan;
    scan.ranges_m = std::move(ranges_m);
    return scan;
}

bool moves(const std::vector<float>& later_m, int times = 5) {
    ScanChange change;
    change.add(beams({1.0F, 2.0F, 3.0F, LaserScan::no_return}));
    for (int i = 0; i < times; ++i) {
        change.add(beams(later_m));
    }
    return change.moves();
}

TEST(ScanChange, HalfOfTheBeamsMustChangeInSeveralScans) {
    EXPECT_TRUE(moves({1.2F, 2.2F, 3.0F, 4.0F}));
    EXPECT_FALSE(moves({1.2F, 2.2F, 3.0F, 4.0F}, 2));
    EXPECT_FALSE(moves({1.1F, 2.1F, 3.1F, 4.0F})) << "noise";
    EXPECT_FALSE(moves({1.0F, 2.0F, 1.0F, 4.0F})) << "somebody who walks past";
    EXPECT_FALSE(moves({LaserScan::invalid, LaserScan::invalid, LaserScan::invalid, LaserScan::invalid}));
}

TEST(ScanChange, ScansOfOtherSizesAreNotCompared) {
    EXPECT_FALSE(moves({5.0F, 5.0F, 5.0F}));
    EXPECT_FALSE(ScanChange().moves());
}

}  // namespace
}  // namespace ddtool

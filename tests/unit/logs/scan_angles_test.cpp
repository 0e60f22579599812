#include "logs/stream/scan_angles.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

namespace ddtool {
namespace {

LaserScan fan(std::size_t beams, double angle_min_rad, double angle_increment_rad) {
    LaserScan scan;
    scan.angle_min_rad = angle_min_rad;
    scan.angle_increment_rad = angle_increment_rad;
    scan.ranges_m.assign(beams, 1.0F);
    return scan;
}

TEST(ScanAngles, InRadiansStayAsTheyAre) {
    for (LaserScan scan :
         {fan(360, -3.14, 0.0175), fan(1081, 2.36, -0.00436), fan(390, -3.2, 0.0175), fan(1, 0.0, 0.0)}) {
        const LaserScan before = scan;
        EXPECT_EQ(read_angles(scan), ScanAngles::radians);
        EXPECT_EQ(scan.angle_min_rad, before.angle_min_rad);
        EXPECT_EQ(scan.angle_increment_rad, before.angle_increment_rad);
    }
}

TEST(ScanAngles, InDegreesAreTurnedIntoRadians) {
    LaserScan scan = fan(360, -180.0, 1.0);
    EXPECT_EQ(read_angles(scan), ScanAngles::degrees);
    EXPECT_NEAR(scan.angle_min_rad, -std::numbers::pi, 1e-9);
    EXPECT_NEAR(scan.angle_rad(359), std::numbers::pi * 179.0 / 180.0, 1e-9);
}

TEST(ScanAngles, ThatCannotBeAreSaid) {
    LaserScan twice = fan(360, -3.14, 0.035);
    EXPECT_EQ(read_angles(twice), ScanAngles::impossible);
    EXPECT_THAT(angle_fault(twice), testing::HasSubstr("360 beams cover 720 degrees, expected at most a full turn"));
    for (LaserScan scan : {fan(360, -3.14, 0.0), fan(360, NAN, 0.01), fan(360, 0.0, INFINITY), fan(360, 0.0, 1e30)}) {
        EXPECT_EQ(read_angles(scan), ScanAngles::impossible);
    }
}

}  // namespace
}  // namespace ddtool

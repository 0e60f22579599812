#include "logs/stream/scan_motion.hpp"

#include <gtest/gtest.h>

#include "room_scan.hpp"

namespace ddtool {
namespace {

TEST(ScanMotion, IsFoundInARoom) {
    RandomStream random({1});
    for (const int beams : {100, 360, 1080}) {
        for (const Pose2& moved : {Pose2{0.12, 0.03, 0.05}, Pose2{-0.3, 0.0, 0.0}, Pose2{0.0, 0.2, -0.1}, Pose2{}}) {
            const Pose2 from{0.5, -0.3, 0.4};
            const auto found = motion_between(test::room_scan(from, 0.0, random, beams),
                                              test::room_scan(from * moved, 0.2, random, beams));
            ASSERT_TRUE(found) << beams;
            EXPECT_NEAR(found->x_m, moved.x_m, 0.01) << beams;
            EXPECT_NEAR(found->y_m, moved.y_m, 0.01) << beams;
            EXPECT_NEAR(found->theta_rad, moved.theta_rad, 0.005) << beams;
        }
    }
}

TEST(ScanMotion, IsNotMadeUpInACorridor) {
    RandomStream random({1});
    const test::Room corridor{.half_length_m = 1000.0, .half_width_m = 1.5};
    for (const int beams : {100, 360, 1080}) {
        EXPECT_FALSE(motion_between(test::room_scan({}, 0.0, random, beams, corridor),
                                    test::room_scan({0.2, 0.0, 0.0}, 0.2, random, beams, corridor)))
            << beams;
    }
}

/// One end of the corridor is in sight, so that a few beams hold the position along it.
TEST(ScanMotion, IsNotShortenedWhereFewBeamsHoldIt) {
    RandomStream random({1});
    const test::Room corridor{.half_length_m = 6.0, .half_width_m = 1.0};
    double sum_m = 0.0;
    for (int i = 0; i < 20; ++i) {
        const Pose2 from{0.1 * i, 0.0, 0.0};
        const auto found = motion_between(test::room_scan(from, 0.0, random, 720, corridor),
                                          test::room_scan(from * Pose2{0.2, 0.0, 0.0}, 0.2, random, 720, corridor));
        sum_m += found ? found->x_m / 20.0 : 0.01;
    }
    EXPECT_NEAR(sum_m, 0.2, 0.02);
}

TEST(ScanMotion, NeedsScansOfTheSameDirections) {
    RandomStream random({1});
    EXPECT_FALSE(motion_between(test::room_scan({}, 0.0, random), test::room_scan({}, 0.0, random, 180)));
    EXPECT_FALSE(motion_between({}, {}));
}

}  // namespace
}  // namespace ddtool

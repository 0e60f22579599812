#include "logs/stream/interleaved_paths.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

/// Where a robot that drives a circle at 0.5 m/s is, seen from a frame that lies elsewhere.
Pose2 circle(double t_s, const Pose2& frame = {}) {
    return frame * Pose2{2.0 * std::sin(0.25 * t_s), 2.0 - 2.0 * std::cos(0.25 * t_s), 0.25 * t_s};
}

StampedPose stamped(double t_s, const Pose2& pose) { return {std::llround(1e9 * t_s), pose}; }

TEST(InterleavedPaths, TwoPublishersAreToldApart) {
    InterleavedPaths paths;
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(paths.add(stamped(0.05 * i, circle(0.05 * i)), 0), 0U);
        if (i % 3 != 0) {
            EXPECT_EQ(paths.add(stamped(0.05 * i + 0.02, circle(0.05 * i, {1.0, 0.5, 0.3})), 0), 1U);
        }
    }
    EXPECT_TRUE(paths.are_interleaved());
    EXPECT_THAT(paths.counts(), testing::ElementsAre(200, 133));
}

TEST(InterleavedPaths, OneThatStandsStillIsAnother) {
    InterleavedPaths paths;
    for (int i = 0; i < 200; ++i) {
        paths.add(stamped(0.05 * i, circle(0.05 * i)), 0);
        paths.add(stamped(0.05 * i + 0.02, {}), 0);
    }
    EXPECT_TRUE(paths.are_interleaved());
}

TEST(InterleavedPaths, TheConnectionTellsWherePathsAreNear) {
    InterleavedPaths paths;
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(paths.add(stamped(0.05 * i, circle(0.05 * i)), 3), 0U);
        EXPECT_EQ(paths.add(stamped(0.05 * i + 0.02, circle(0.05 * i, {0.0, 0.002 * i, 0.0})), 5), 1U);
    }
    EXPECT_TRUE(paths.are_interleaved());
}

TEST(InterleavedPaths, OnePublisherIsOnePath) {
    RandomStream random({3});
    InterleavedPaths paths;
    for (int i = 0; i < 500; ++i) {
        const double t_s = 0.05 * i + random.uniform(0.0, 0.02) + (i > 250 ? 3.0 : 0.0);
        const Pose2 pose = circle(t_s, {0.005 * random.normal(), 0.005 * random.normal(), 0.0});
        paths.add(stamped(0.05 * i + (i > 250 ? 3.0 : 0.0), pose), 0);
    }
    EXPECT_FALSE(paths.are_interleaved());
}

TEST(InterleavedPaths, OneThatStartsAgainIsNotInterleaved) {
    InterleavedPaths paths;
    for (int i = 0; i < 600; ++i) {
        paths.add(stamped(0.05 * i, circle(0.05 * (i % 150))), i < 300 ? 0 : 1);
    }
    EXPECT_FALSE(paths.are_interleaved());
}

TEST(InterleavedPaths, EqualPosesOfTwoPublishersDoNoHarm) {
    InterleavedPaths paths;
    for (int i = 0; i < 200; ++i) {
        paths.add(stamped(0.05 * i, circle(0.05 * i)), 0);
        paths.add(stamped(0.05 * i + 0.001, circle(0.05 * i)), 1);
    }
    EXPECT_FALSE(paths.are_interleaved());
}

}  // namespace
}  // namespace ddtool

#include "logs/stream/interleaved_paths.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <vector>

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
    EXPECT_EQ(paths.poses(0), 200U);
    EXPECT_EQ(paths.poses(1), 133U);
    EXPECT_THAT(paths.lineage(1), testing::ElementsAre(1));
}

TEST(InterleavedPaths, OneThatStandsStillIsAnother) {
    InterleavedPaths paths;
    for (int i = 0; i < 200; ++i) {
        paths.add(stamped(0.05 * i, circle(0.05 * i)), 0);
        paths.add(stamped(0.05 * i + 0.02, {}), 0);
    }
    EXPECT_TRUE(paths.are_interleaved());
}

TEST(InterleavedPaths, PublishersThatAgreedAtFirstBranchOff) {
    InterleavedPaths paths;
    std::size_t first = 0;
    std::size_t second = 0;
    for (int i = 0; i < 400; ++i) {
        first = paths.add(stamped(0.05 * i, circle(0.05 * i)), 0);
        second = paths.add(stamped(0.05 * i + 0.02, circle(0.045 * i)), 0);
    }
    EXPECT_TRUE(paths.are_interleaved());
    EXPECT_NE(first, second);
    EXPECT_EQ(paths.lineage(first).front(), paths.lineage(second).front());
}

TEST(InterleavedPaths, OneThatIsContinuousIsFoundAmongNoise) {
    RandomStream random({3});
    InterleavedPaths paths;
    std::vector<std::size_t> numbers;
    for (int i = 0; i < 300; ++i) {
        numbers.push_back(paths.add(stamped(0.05 * i, circle(0.05 * i)), 0));
        const Pose2 off{0.3 * random.normal(), 0.3 * random.normal(), 0.0};
        paths.add(stamped(0.05 * i + 0.02, off * circle(0.05 * i)), 0);
    }
    EXPECT_TRUE(paths.are_interleaved());
    EXPECT_GT(std::ranges::count(numbers, numbers.back()), 250);
}

TEST(InterleavedPaths, TheConnectionTellsWherePathsAreNear) {
    InterleavedPaths paths;
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(paths.add(stamped(0.05 * i, circle(0.05 * i)), 3), 0U);
        EXPECT_EQ(paths.add(stamped(0.05 * i + 0.02, circle(0.05 * i, {0.0, 0.002 * i, 0.0})), 5), 1U);
    }
    EXPECT_TRUE(paths.are_interleaved());
}

class NoisyPublisher : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Noise, NoisyPublisher, testing::Values(0.0, 0.005, 0.015, 0.03, 0.1, 0.3));

TEST_P(NoisyPublisher, IsOnePath) {
    RandomStream random({3});
    InterleavedPaths paths;
    for (int i = 0; i < 500; ++i) {
        const double t_s = 0.05 * i + random.uniform(0.0, 0.02) + (i > 250 ? 3.0 : 0.0);
        const Pose2 pose = circle(t_s, {GetParam() * random.normal(), GetParam() * random.normal(), 0.0});
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

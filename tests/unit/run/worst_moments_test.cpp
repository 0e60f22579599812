#include "run/worst_moments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

ParticleSnapshot at(double time_s) {
    return {.stamp_ns = std::llround(1e9 * time_s), .update = 0, .odometry_motion = {}, .particles = {}};
}

TEST(WorstMoments, AreFewFarApartAndHoldTheWorst) {
    RandomStream random({1});
    for (int run = 0; run < 50; ++run) {
        WorstMoments worst(4, 3.0);
        double highest = 0.0;
        for (double time_s = 0.0; time_s < 60.0; time_s += 0.5) {
            const double degree = random.uniform();
            highest = std::max(highest, degree);
            worst.offer(at(time_s), {degree});
        }
        const auto moments = worst.ranked();
        ASSERT_EQ(moments.size(), 4);
        EXPECT_EQ(moments.front().degree, highest);
        for (std::size_t index = 1; index < moments.size(); ++index) {
            EXPECT_LE(moments[index].degree, moments[index - 1].degree);
            for (std::size_t other = 0; other < index; ++other) {
                EXPECT_GE(std::abs(moments[index].swarm.stamp_ns - moments[other].swarm.stamp_ns), 3'000'000'000);
            }
        }
    }
}

TEST(WorstMoments, AreNoneWithoutDegeneracy) {
    WorstMoments worst;
    worst.offer(at(0.0), {0.0});
    worst.offer(at(10.0), {NAN});
    EXPECT_TRUE(worst.ranked().empty());
}

TEST(WorstMoments, KeepTheEarlierOfEqualOnes) {
    WorstMoments worst(2, 3.0);
    for (const double time_s : {0.0, 10.0, 20.0, 30.0}) {
        worst.offer(at(time_s), {1.0});
    }
    const auto moments = worst.ranked();
    ASSERT_EQ(moments.size(), 2);
    EXPECT_EQ(moments[0].swarm.stamp_ns, 0);
    EXPECT_EQ(moments[1].swarm.stamp_ns, 10'000'000'000);
}

}  // namespace
}  // namespace ddtool

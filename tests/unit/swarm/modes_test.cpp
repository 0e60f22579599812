#include "swarm/modes.hpp"

#include <gtest/gtest.h>

namespace ddtool {
namespace {

SnapshotParticle at(const Pose2& pose, double weight) {
    SnapshotParticle particle;
    particle.pose = pose;
    particle.weight = weight;
    return particle;
}

TEST(Modes, HeadingsAreDifferentPlaces) {
    std::vector<SnapshotParticle> swarm;
    for (const double heading_rad : {3.1, -3.1, 3.1, -3.1}) {  // 0.08 apart
        swarm.push_back(at({0.0, 0.0, heading_rad}, 0.2));
    }
    swarm.push_back(at({0.0, 0.0, 0.0}, 0.2));
    const std::vector<Mode> modes = modes_of(swarm);
    ASSERT_EQ(modes.size(), 2U);
    EXPECT_NEAR(modes[0].weight, 0.8, 1e-12);
    EXPECT_NEAR(modes[1].weight, 0.2, 1e-12);
}

/// Many light particles at one place outweigh a heavy one elsewhere.
TEST(Modes, TheHeaviestPlaceComesFirst) {
    std::vector<SnapshotParticle> swarm{at({10.0, 0.0, 0.0}, 0.3)};
    for (int i = 0; i < 7; ++i) {
        swarm.push_back(at({0.01 * i, 0.0, 0.0}, i == 3 ? 0.16 : 0.09));
    }
    const std::vector<Mode> modes = modes_of(swarm);
    ASSERT_EQ(modes.size(), 2U);
    EXPECT_EQ(modes[0].particles.size(), 7U);
    EXPECT_EQ(modes[0].particles.front(), 4U);
    EXPECT_EQ(modes[1].particles.front(), 0U);
}

}  // namespace
}  // namespace ddtool

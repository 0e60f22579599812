#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "swarms.hpp"

namespace ddtool {
namespace {

TEST(ParticleRenderer, AllocatesNothingOnceItHasDrawnAsManyParticles) {
    const std::vector<SnapshotParticle> many = test::normal_swarm(1000, 1, {1.0, 0.1});
    const std::vector<SnapshotParticle> few = test::normal_swarm(30, 2, {2.0, 2.0});
    for (const Swarm swarm : {Swarm::absolute, Swarm::step, Swarm::response}) {
        ParticleRenderer renderer({.swarm = swarm});
        ParticleImage image;
        renderer.render(many, image);
        const int before = test::allocations;
        renderer.render(few, image);
        renderer.render(many, image);
        EXPECT_EQ(test::allocations - before, 0);
    }
}

}  // namespace
}  // namespace ddtool

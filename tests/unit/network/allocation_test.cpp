#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "dd_weights.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "network/dd_network.hpp"
#include "swarms.hpp"

namespace ddtool {
namespace {

TEST(DDNetwork, AllocatesNothingWhenItRuns) {
    constexpr std::size_t size_px = 64;
    const network::DDModelTable& table = network::ddmodel_lite_table();
    network::NamedWeights weights(test::drawn_dd_weights(table, size_px));
    network::DDNetwork network(weights, table, size_px);
    const std::vector<float> image(size_px * size_px, 1.0F);
    const int before = test::allocations;
    EXPECT_GT(before, 0);
    (void)network.run(image);
    EXPECT_EQ(test::allocations, before);
}

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

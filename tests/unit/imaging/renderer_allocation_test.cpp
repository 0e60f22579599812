#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "imaging/particle_renderer.hpp"
#include "swarms.hpp"

namespace {
std::atomic<int> allocations{0};
}  // namespace

// Not inline: GCC would take one half of a pair for a mismatch with the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size)) {
        return memory;
    }
    throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace ddtool {
namespace {

TEST(ParticleRenderer, AllocatesNothingOnceItHasDrawnAsManyParticles) {
    const std::vector<SnapshotParticle> many = test::normal_swarm(1000, 1, {1.0, 0.1});
    const std::vector<SnapshotParticle> few = test::normal_swarm(30, 2, {2.0, 2.0});
    for (const Swarm swarm : {Swarm::absolute, Swarm::step, Swarm::response}) {
        ParticleRenderer renderer({.swarm = swarm});
        ParticleImage image;
        renderer.render(many, image);
        const int before = allocations;
        renderer.render(few, image);
        renderer.render(many, image);
        EXPECT_EQ(allocations - before, 0);
    }
}

}  // namespace
}  // namespace ddtool

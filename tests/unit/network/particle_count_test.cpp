// Measures how similar the images of one distribution are if it is drawn with different numbers of particles. Prints
// the figures of docs/reports/2026-11-22-particle-images.md.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdio>

#include "ddtool/network/particle_renderer.hpp"
#include "swarms.hpp"

namespace ddtool {
namespace {

struct Distribution {
    const char* name;
    Swarm swarm;
    test::SwarmShape shape;
};

/// The absolute swarms of a long run (in a room, a corridor and a ring), and step swarms of which matching determines
/// both directions, one, or none. The prediction has a standard deviation of 0.1 m along the motion and 0.03 m across
/// it.
constexpr std::array distributions{
    Distribution{"absolute, room", Swarm::absolute, {0.035, 0.035}},
    Distribution{"absolute, corridor", Swarm::absolute, {0.85, 0.035}},
    Distribution{"absolute, ring", Swarm::absolute, {1.3, 0.4}},
    Distribution{"step, room", Swarm::step, {0.008, 0.008}},
    Distribution{"step, corridor", Swarm::step, {0.1, 0.005}},
    Distribution{"step, open", Swarm::step, {0.1, 0.03}},
};
constexpr std::array<std::size_t, 5> counts{15, 30, 60, 200, 500};
constexpr std::size_t many = 1000;
constexpr std::uint64_t draws = 20;

using Blocks = std::array<double, 784>;

/// The number of marked pixels in each of 28 x 28 blocks of 8 x 8 pixels; a block is a token of the network.
Blocks blocks_of(const ParticleImage& image) {
    Blocks blocks{};
    for (std::size_t index = 0; index < image.pixels.size(); ++index) {
        const std::size_t block = index / 224 / 8 * 28 + index % 224 / 8;
        blocks[block] += image.pixels[index] == ParticleImage::marked ? 1.0 : 0.0;
    }
    return blocks;
}

/// Sorensen's overlap of the marked pixels, 2 sum min(a, b) / sum (a + b): 1 for equal blocks, 0 for disjoint ones.
double overlap(const Blocks& a, const Blocks& b) {
    double shared = 0.0;
    double all = 0.0;
    for (std::size_t block = 0; block < a.size(); ++block) {
        shared += 2.0 * std::min(a[block], b[block]);
        all += a[block] + b[block];
    }
    return shared / all;
}

double mean_overlap(const Distribution& distribution, std::size_t particles, bool augmentation) {
    ParticleRenderer renderer({.swarm = distribution.swarm, .gaussian_augmentation = augmentation});
    const auto blocks = [&](std::size_t count, std::uint64_t seed) {
        ParticleImage image;
        renderer.render(test::normal_swarm(count, seed, distribution.shape), image);
        return blocks_of(image);
    };
    double sum = 0.0;
    for (std::uint64_t draw = 0; draw < draws; ++draw) {
        sum += overlap(blocks(particles, draw), blocks(many, draws + draw));
    }
    return sum / draws;
}

TEST(ParticleCount, MattersLessWithAugmentation) {
    std::printf("mean overlap with images of %zu particles: without | with augmentation\n", many);
    for (const Distribution& distribution : distributions) {
        std::printf("| %s |", distribution.name);
        double before = 0.0;
        for (const std::size_t particles : counts) {
            const double without = mean_overlap(distribution, particles, false);
            const double with = mean_overlap(distribution, particles, true);
            std::printf(" %.2f, %.2f |", without, with);
            EXPECT_GT(with, without) << distribution.name << ", " << particles << " particles";
            EXPECT_GT(with, before) << "more particles come closer";
            before = with;
        }
        std::printf("\n");
    }
}

}  // namespace
}  // namespace ddtool

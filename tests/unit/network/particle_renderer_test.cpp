#include "ddtool/network/particle_renderer.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "swarms.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

using Particles = std::vector<SnapshotParticle>;

ParticleImage render(const Particles& particles, const ImageSettings& settings = {}) {
    ParticleImage image;
    ParticleRenderer(settings).render(particles, image);
    return image;
}

auto marked_in(const ParticleImage& image) {
    return std::count(image.pixels.begin(), image.pixels.end(), ParticleImage::marked);
}

/// Every combination of image settings: the swarms, mapping on and off, and augmentation on and off.
std::vector<ImageSettings> every_way(const std::vector<Swarm>& swarms = {Swarm::absolute, Swarm::step,
                                                                         Swarm::response}) {
    std::vector<ImageSettings> ways;
    for (const Swarm swarm : swarms) {
        for (const bool mapping : {true, false}) {
            for (const bool augmentation : {true, false}) {
                ways.push_back({.swarm = swarm, .linear_mapping = mapping, .gaussian_augmentation = augmentation});
            }
        }
    }
    return ways;
}

/// A swarm that fills half of the canvas, both as absolute and as step swarm.
Particles wide_swarm(std::uint64_t seed) {
    Particles swarm = test::normal_swarm(60, seed, {1.0, 0.4});
    for (SnapshotParticle& particle : swarm) {
        // A smaller share is left across than along, so that the weakest direction is unique.
        particle.matched_motion = {particle.predicted_motion.x_m, 0.5 * particle.predicted_motion.y_m, 0.0};
    }
    return swarm;
}

Particles transformed(Particles particles, const auto& transform) {
    for (SnapshotParticle& particle : particles) {
        transform(particle.pose);
        transform(particle.matched_motion);
    }
    return particles;
}

Particles shifted(const Particles& particles, double x_m, double y_m) {
    return transformed(particles, [&](Pose2& place) {
        place.x_m += x_m;
        place.y_m += y_m;
    });
}

/// Rounds to multiples of 2^-10 m. Sums of such numbers up to 2^43 m are exact, and they often lie on a pixel's border.
Particles on_a_lattice(const Particles& particles) {
    return transformed(particles, [](Pose2& place) {
        place.x_m = std::round(place.x_m * 1024.0) / 1024.0;
        place.y_m = std::round(place.y_m * 1024.0) / 1024.0;
    });
}

TEST(ParticleRenderer, DrawsTheSameImageWhereverTheSwarmIs) {
    for (const Swarm swarm : {Swarm::absolute, Swarm::step, Swarm::response}) {
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            RandomStream random({seed, 1});
            const Particles here = wide_swarm(seed);
            const double x_m = random.uniform(-1e5, 1e5);
            const double y_m = random.uniform(-1e5, 1e5);
            // At 1e5 m, sums are rounded by at most 7e-12 m, which is 1e-8 of a pixel. No particle is that close to a
            // border.
            EXPECT_EQ(render(shifted(here, x_m, y_m), {.swarm = swarm}), render(here, {.swarm = swarm}));
        }
    }
}

TEST(ParticleRenderer, IsExactForShiftsThatAre) {
    const ImageSettings pixels_on_the_lattice{.size_px = 256, .canvas_m = 8.0};
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        RandomStream random({seed, 1});
        const Particles here = on_a_lattice(wide_swarm(seed));
        const double x_m = std::round(random.uniform(-1e8, 1e8)) / 1024.0;
        const double y_m = std::round(random.uniform(5e15, 8e15)) / 1024.0;
        EXPECT_EQ(render(shifted(here, x_m, y_m), pixels_on_the_lattice), render(here, pixels_on_the_lattice));
    }
}

TEST(ParticleRenderer, DoesNotCareForTheOrderOfTheParticles) {
    for (const ImageSettings& settings : every_way()) {
        Particles swarm = wide_swarm(1);
        const ParticleImage image = render(swarm, settings);
        RandomStream random({2});
        std::shuffle(swarm.begin(), swarm.end(), random);
        EXPECT_EQ(render(swarm, settings), image);
    }
}

/// The image turned by 90 degrees counter-clockwise.
ParticleImage turned(const ParticleImage& image) {
    const std::size_t size = image.size_px;
    ParticleImage result = image;
    for (std::size_t row = 0; row < size; ++row) {
        for (std::size_t column = 0; column < size; ++column) {
            result.pixels[(size - 1 - column) * size + row] = image.pixels[row * size + column];
        }
    }
    return result;
}

TEST(ParticleRenderer, TurnsTheImageWithTheSwarm) {
    for (const ImageSettings& settings : every_way({Swarm::absolute, Swarm::step})) {
        const Particles swarm = wide_swarm(3);
        const Particles turned_swarm = transformed(swarm, [](Pose2& place) { place = {-place.y_m, place.x_m, 0.0}; });
        EXPECT_EQ(render(turned_swarm, settings), turned(render(swarm, settings)));
    }
}

TEST(ParticleRenderer, ShowsXToTheRightAndYUpwards) {
    const ImageSettings pixels{.gaussian_augmentation = false};
    const ParticleImage image = render(test::swarm_at({{0.0, 0.0}, {4.0, 0.0}, {4.0, 2.0}}), pixels);
    const auto at = [&](std::size_t row, std::size_t column) { return image.pixels[row * 224 + column]; };
    EXPECT_EQ(at(134, 67), ParticleImage::marked) << "3 m from the left, 4 m from below";
    EXPECT_EQ(at(134, 156), ParticleImage::marked);
    EXPECT_EQ(at(89, 156), ParticleImage::marked);
    EXPECT_EQ(marked_in(image), 3);
}

TEST(ParticleRenderer, DrawsTheStepSwarmAlikeHoweverFarTheStepWent) {
    const ImageSettings step{.swarm = Swarm::step};
    const Particles swarm = wide_swarm(4);
    Particles longer = swarm;
    for (SnapshotParticle& particle : longer) {
        for (Pose2* motion : {&particle.matched_motion, &particle.predicted_motion}) {
            *motion = {8.0 * motion->x_m, 8.0 * motion->y_m, 0.0};
        }
    }
    EXPECT_EQ(render(longer, step), render(swarm, step));
}

TEST(ParticleRenderer, DropsWhatIsNotFinite) {
    const double inf = std::numeric_limits<double>::infinity();
    const Particles swarm = wide_swarm(5);
    Particles damaged = swarm;
    for (const Pose2& place : {Pose2{std::nan(""), 0.0, 0.0}, Pose2{0.0, -inf, 0.0}, Pose2{inf, std::nan(""), 0.0}}) {
        damaged.push_back({place, place, place, 0.0, 0.0, 0.0, 0.0});
    }
    for (const ImageSettings& settings : every_way()) {
        EXPECT_EQ(render(damaged, settings), render(swarm, settings));
    }
}

TEST(ParticleRenderer, DrawsNothingForNobody) {
    for (const ImageSettings& settings : every_way()) {
        EXPECT_EQ(marked_in(render({}, settings)), 0);
    }
}

/// Swarms with coordinates that no filter should give, such as infinity.
std::vector<Particles> extreme_swarms() {
    const double inf = std::numeric_limits<double>::infinity();
    const double huge = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    std::vector<Particles> swarms{{}, test::normal_swarm(1, 1, {}), test::normal_swarm(100'000, 1, {3.0, 3.0})};
    std::vector<Point2> everything;
    for (const double x : {0.0, 5.0, -5.0, 1e30, -1e30, huge, -huge, tiny, inf, -inf, std::nan("")}) {
        swarms.push_back(test::swarm_at({{x, 0.0}, {0.0, x}, {x, x}}));
        everything.insert(everything.end(), {{x, 0.0}, {0.0, x}, {x, -x}});
    }
    swarms.push_back(test::swarm_at(everything));
    for (Particles& swarm : swarms) {
        for (SnapshotParticle& particle : swarm) {
            particle.predicted_motion = particle.pose;
        }
    }
    return swarms;
}

TEST(ParticleRenderer, WritesNothingBesideTheImageForAnyInput) {
    constexpr std::size_t guard = 1000;
    constexpr std::uint8_t untouched = 77;
    for (ImageSettings settings : every_way()) {
        for (const std::size_t size_px : std::array<std::size_t, 3>{1, 3, 224}) {
            settings.size_px = size_px;
            ParticleRenderer renderer(settings);
            for (const Particles& swarm : extreme_swarms()) {
                std::vector<std::uint8_t> memory(size_px * size_px + 2 * guard, untouched);
                const std::span<std::uint8_t> pixels = std::span(memory).subspan(guard, size_px * size_px);
                renderer.render(swarm, pixels);
                EXPECT_EQ(std::count(memory.begin(), memory.end(), untouched), 2 * guard);
                EXPECT_EQ(std::count(pixels.begin(), pixels.end(), untouched), 0);
            }
        }
    }
}

TEST(ParticleRenderer, StartsAfreshWithEveryImage) {
    ParticleRenderer renderer({});
    ParticleImage image;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        renderer.render(wide_swarm(seed), image);
        EXPECT_EQ(image, render(wide_swarm(seed)));
    }
}

TEST(ParticleRenderer, GivesFloatsOfZeroAndOne) {
    ParticleRenderer renderer({});
    const ParticleImage image = render(wide_swarm(6));
    std::vector<float> floats(image.pixels.size(), 0.5F);
    renderer.render(wide_swarm(6), std::span(floats));
    std::vector<float> expected;
    for (const std::uint8_t pixel : image.pixels) {
        expected.push_back(static_cast<float>(pixel) / 255.0F);
    }
    EXPECT_EQ(floats, expected);
}

TEST(ParticleRenderer, RefusesMemoryOfAnotherSize) {
    std::vector<float> floats(100);
    EXPECT_THAT(test::thrown_text([&] { ParticleRenderer({}).render({}, std::span(floats)); }),
                testing::HasSubstr("expected 50176"));
}

}  // namespace
}  // namespace ddtool

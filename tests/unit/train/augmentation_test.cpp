#include "train/augmentation.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "ddtool/network/linear_mapping.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "drawn_swarm.hpp"

namespace ddtool::train {
namespace {

using Particles = std::vector<SnapshotParticle>;
using test::drawn_swarm;

constexpr AugmentationSettings none{.rotate = false, .flip = false, .resample_particles = false};
constexpr AugmentationSettings rotate{.rotate = true, .flip = false, .resample_particles = false};
constexpr AugmentationSettings flip{.rotate = false, .flip = true, .resample_particles = false};
constexpr AugmentationSettings turn_and_flip{.rotate = true, .flip = true, .resample_particles = false};
constexpr AugmentationSettings resample{.rotate = false, .flip = false, .resample_particles = true};

Particles augmented(Particles particles, const AugmentationSettings& settings, std::uint64_t seed) {
    RandomStream random({seed});
    augment(particles, settings, random);
    return particles;
}

constexpr std::array<Pose2 SnapshotParticle::*, 3> positions{&SnapshotParticle::pose, &SnapshotParticle::matched_motion,
                                                             &SnapshotParticle::predicted_motion};

void expect_near(const Particles& actual, const Particles& expected) {
    ASSERT_EQ(actual.size(), expected.size());
    for (std::size_t index = 0; index < actual.size(); ++index) {
        for (const auto position : positions) {
            EXPECT_NEAR(distance_m(actual[index].*position, expected[index].*position), 0.0, 1e-12);
            EXPECT_NEAR(wrap_angle((actual[index].*position).theta_rad - (expected[index].*position).theta_rad), 0.0,
                        1e-12);
        }
        EXPECT_EQ(actual[index].log_likelihood, expected[index].log_likelihood);
        EXPECT_EQ(actual[index].weight, expected[index].weight);
    }
}

Point2 mean_of(const Particles& particles, Pose2 SnapshotParticle::*position) {
    Point2 mean;
    for (const SnapshotParticle& particle : particles) {
        mean.x_m += (particle.*position).x_m / static_cast<double>(particles.size());
        mean.y_m += (particle.*position).y_m / static_cast<double>(particles.size());
    }
    return mean;
}

ParticleImage render(const Particles& particles, Swarm swarm) {
    ParticleImage image;
    ParticleRenderer({.swarm = swarm, .size_px = 64, .gaussian_augmentation = false}).render(particles, image);
    return image;
}

/// The image mirrored from top to bottom.
ParticleImage mirrored(ParticleImage image) {
    for (std::size_t row = 0; row < image.size_px / 2; ++row) {
        const auto at = [&](std::size_t each) {
            return image.pixels.begin() + static_cast<std::ptrdiff_t>(each * image.size_px);
        };
        std::swap_ranges(at(row), at(row + 1), at(image.size_px - 1 - row));
    }
    return image;
}

TEST(Augmentation, ChangesNothingWhereAllIsOff) {
    const Particles swarm = drawn_swarm(40, 1);
    const Particles same = augmented(swarm, none, 2);
    for (std::size_t index = 0; index < swarm.size(); ++index) {
        for (const auto position : positions) {
            EXPECT_EQ(same[index].*position, swarm[index].*position);
        }
    }
}

TEST(Augmentation, KeepsDistancesAndTheCanvas) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const Particles swarm = drawn_swarm(30, seed);
        const Particles changed = augmented(swarm, turn_and_flip, seed);
        for (const auto position : positions) {
            for (std::size_t index = 1; index < swarm.size(); ++index) {
                EXPECT_NEAR(distance_m(changed[index].*position, changed[0].*position),
                            distance_m(swarm[index].*position, swarm[0].*position), 1e-12);
            }
        }
        const ImageSettings step{.swarm = Swarm::step};
        EXPECT_NEAR(canvas_side_m(changed, step), canvas_side_m(swarm, step), 1e-12);
    }
}

TEST(Augmentation, TurnsPosesAboutTheirMiddleAndMotionsAboutThePreviousPose) {
    const Particles swarm = drawn_swarm(30, 5);
    const Particles changed = augmented(swarm, turn_and_flip, 5);
    const Point2 before = mean_of(swarm, &SnapshotParticle::pose);
    const Point2 after = mean_of(changed, &SnapshotParticle::pose);
    EXPECT_NEAR(std::hypot(after.x_m - before.x_m, after.y_m - before.y_m), 0.0, 1e-12);
    for (std::size_t index = 0; index < swarm.size(); ++index) {
        for (const auto motion : {&SnapshotParticle::matched_motion, &SnapshotParticle::predicted_motion}) {
            EXPECT_NEAR(distance_m(changed[index].*motion, {}), distance_m(swarm[index].*motion, {}), 1e-12);
        }
    }
}

/// Turns all poses about the world's origin, and all motions about the robot's previous pose.
Particles turned(Particles particles, double turn_rad) {
    for (SnapshotParticle& particle : particles) {
        for (const auto position : positions) {
            particle.*position = Pose2{0.0, 0.0, turn_rad} * particle.*position;
        }
    }
    return particles;
}

TEST(Augmentation, DrawsTheImageOfTheTurnedSwarm) {
    const Particles swarm = drawn_swarm(30, 6);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Particles changed = augmented(swarm, rotate, seed);
        const double turn_rad = changed[0].pose.theta_rad - swarm[0].pose.theta_rad;
        for (const Swarm which : {Swarm::absolute, Swarm::step}) {
            EXPECT_EQ(render(changed, which), render(turned(swarm, turn_rad), which));
            EXPECT_NE(render(changed, which), render(swarm, which));
        }
        EXPECT_NEAR(changed[0].matched_motion.theta_rad, swarm[0].matched_motion.theta_rad, 1e-12);
    }
}

TEST(Augmentation, TurnsEveryWayAlike) {
    std::array<int, 8> octants{};
    const Particles swarm = drawn_swarm(2, 1);
    constexpr int draws = 4000;
    for (std::uint64_t seed = 0; seed < draws; ++seed) {
        const Particles changed = augmented(swarm, rotate, seed);
        const double turn = wrap_angle(changed[0].pose.theta_rad - swarm[0].pose.theta_rad);
        ++octants[std::min<std::size_t>(7, static_cast<std::size_t>((turn / std::numbers::pi + 1.0) * 4.0))];
    }
    EXPECT_THAT(octants, testing::Each(testing::AllOf(testing::Gt(395), testing::Lt(605)))) << "five sd about 500";
}

TEST(Augmentation, MirroredTwiceIsAsBefore) {
    const Particles swarm = drawn_swarm(30, 7);
    int mirrors = 0;
    for (std::uint64_t seed = 0; seed < 400; ++seed) {
        const Particles once = augmented(swarm, flip, seed);
        expect_near(augmented(once, flip, seed), swarm);
        mirrors += once[0].pose.theta_rad == swarm[0].pose.theta_rad ? 0 : 1;
    }
    EXPECT_NEAR(mirrors, 200, 50) << "five sd";
}

TEST(Augmentation, MirrorsTheImage) {
    const Particles swarm = drawn_swarm(30, 8);
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const Particles changed = augmented(swarm, flip, seed);
        const bool is_mirrored = changed[0].pose.theta_rad != swarm[0].pose.theta_rad;
        for (const Swarm which : {Swarm::absolute, Swarm::step}) {
            const ParticleImage before = render(swarm, which);
            EXPECT_EQ(render(changed, which), is_mirrored ? mirrored(before) : before);
        }
    }
}

TEST(Augmentation, ThinsToAChoiceOfTheParticles) {
    constexpr std::size_t all = 200;
    const Particles swarm = drawn_swarm(all, 9);
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        const Particles fewer = augmented(swarm, resample, seed);
        EXPECT_GE(fewer.size(), resample.least_particles);
        EXPECT_LE(fewer.size(), all);
        std::set<double> numbers;
        double weights = 0.0;
        for (const SnapshotParticle& particle : fewer) {
            numbers.insert(particle.log_likelihood);
            weights += particle.weight;
            EXPECT_EQ(particle.pose, swarm[static_cast<std::size_t>(particle.log_likelihood)].pose);
        }
        EXPECT_EQ(numbers.size(), fewer.size()) << "none twice";
        EXPECT_NEAR(weights, 1.0, 1e-12);
    }
}

TEST(Augmentation, ThinsEvenlyInTheLogarithmOfTheNumber) {
    constexpr std::size_t all = 240;
    const Particles swarm = drawn_swarm(all, 10);
    constexpr int draws = 4000;
    std::array<int, 4> doublings{};  // counts of swarms with 15-29, 30-59, 60-119 and 120-240 particles
    int whole = 0;
    for (std::uint64_t seed = 0; seed < draws; ++seed) {
        const std::size_t count = augmented(swarm, resample, seed).size();
        ++doublings[std::min<std::size_t>(3, static_cast<std::size_t>(std::log2(static_cast<double>(count) / 15.0)))];
        whole += count == all ? 1 : 0;
    }
    EXPECT_THAT(doublings, testing::Each(testing::AllOf(testing::Gt(860), testing::Lt(1140)))) << "five sd about 1000";
    EXPECT_GT(whole, 0) << "all of them are drawn too: 0.15 % of the time";
}

TEST(Augmentation, LeavesSmallSwarmsWhole) {
    for (const std::size_t count : {0U, 1U, 14U, 15U}) {
        EXPECT_EQ(augmented(drawn_swarm(count, 11), resample, 12).size(), count);
    }
}

TEST(Augmentation, KeepsWhatIsNotFiniteApart) {
    Particles swarm = drawn_swarm(30, 13);
    const Particles changed = augmented(swarm, rotate, 14);
    swarm.push_back(swarm[0]);
    swarm.back().pose.x_m = std::nan("");
    Particles with_lost = augmented(swarm, rotate, 14);
    EXPECT_TRUE(std::isnan(with_lost.back().pose.x_m));
    with_lost.pop_back();
    expect_near(with_lost, changed);
}

}  // namespace
}  // namespace ddtool::train

#include "swarm/weights.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ddtool {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Pointwise;

TEST(NormalisedWeights, IgnoresACommonOffset) {
    const std::vector<double> log_weights{-3.0, -1.0, -2.0};
    const std::vector<double> shifted{-1e6 - 3.0, -1e6 - 1.0, -1e6 - 2.0};
    EXPECT_THAT(normalised_weights(shifted), Pointwise(DoubleNear(1e-9), normalised_weights(log_weights)));
}

TEST(NormalisedWeights, StaysFiniteForNonFiniteInput) {
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_THAT(normalised_weights(std::vector{-inf, -1.0, std::nan("")}), testing::ElementsAre(0.0, 1.0, 0.0));
    EXPECT_THAT(normalised_weights(std::vector{-inf, std::nan("")}), Each(0.5));
}

TEST(EffectiveSampleSize, CountsEqualWeightsAndOneWinner) {
    EXPECT_NEAR(effective_sample_size(std::vector<double>(30, 1.0 / 30)), 30.0, 1e-9);
    EXPECT_NEAR(effective_sample_size(std::vector{1.0, 0.0, 0.0}), 1.0, 1e-12);
}

TEST(SystematicResampling, GivesEachParticleItsShareWithinOne) {
    const std::vector<double> weights = normalised_weights(std::vector{0.0, -1.0, -0.3, -4.0, -0.1});
    for (const double offset : {0.0, 0.3, 0.999999}) {
        const std::vector<std::size_t> chosen = systematic_resampling(weights, offset);
        ASSERT_EQ(chosen.size(), weights.size());
        for (std::size_t particle = 0; particle < weights.size(); ++particle) {
            const auto copies = static_cast<double>(std::count(chosen.begin(), chosen.end(), particle));
            EXPECT_LT(std::abs(copies - 5.0 * weights[particle]), 1.0) << "particle " << particle;
        }
    }
}

TEST(SystematicResampling, NeverPicksAParticleWithoutWeight) {
    // The weights' sum is slightly below one, so that the last slots lie beyond it.
    const std::vector<double> weights{0.0, 0.5, 0.5 - 1e-9, 0.0};
    EXPECT_THAT(systematic_resampling(weights, 1.0 - 1e-10), testing::ElementsAre(1, 1, 2, 2));
}

TEST(Dispersion, IsVarianceOverMagnitudeOfTheMean) {
    EXPECT_DOUBLE_EQ(dispersion(std::vector{1.0, 3.0}), 0.5);
    EXPECT_DOUBLE_EQ(dispersion(std::vector{-1.0, -3.0}), 0.5);
    EXPECT_DOUBLE_EQ(dispersion(std::vector{2.0, 2.0}), 0.0);
    EXPECT_DOUBLE_EQ(dispersion(std::vector<double>{}), 0.0);
}

TEST(Dispersion, OfNormalisedWeightsNeverReachesOne) { EXPECT_LT(dispersion(std::vector{1.0, 0.0, 0.0, 0.0}), 1.0); }

}  // namespace
}  // namespace ddtool

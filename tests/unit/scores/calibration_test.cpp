#include "scores/calibration.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

struct Forecasts {
    std::vector<double> probabilities;
    std::vector<bool> positive;
};

/// Random forecasts, and events that occur with exactly the forecast probabilities.
Forecasts drawn_probabilities(std::size_t count) {
    RandomStream random({5});
    Forecasts forecasts;
    for (std::size_t i = 0; i < count; ++i) {
        forecasts.probabilities.push_back(random.uniform());
        forecasts.positive.push_back(random.uniform() < forecasts.probabilities.back());
    }
    return forecasts;
}

Forecasts heated(Forecasts forecasts, double temperature) {
    for (double& probability : forecasts.probabilities) {
        probability = at_temperature(probability, temperature);
    }
    return forecasts;
}

double error_of(const Forecasts& forecasts) {
    return expected_calibration_error(reliability(forecasts.probabilities, forecasts.positive));
}

double negative_log_likelihood(const Forecasts& forecasts) {
    double sum = 0.0;
    for (std::size_t i = 0; i < forecasts.positive.size(); ++i) {
        sum -= std::log(forecasts.positive[i] ? forecasts.probabilities[i] : 1.0 - forecasts.probabilities[i]);
    }
    return sum;
}

TEST(Reliability, EveryForecastIsInTheBinThatHoldsIt) {
    const std::vector<double> probabilities{0.0, 0.1, 0.1 + 1e-9, 0.5, 1.0};
    const auto bins = reliability(probabilities, {false, true, true, false, true}, 10);
    ASSERT_EQ(bins.size(), 10U);
    EXPECT_EQ(bins[0].count, 2U);
    EXPECT_EQ(bins[1].count, 1U);
    EXPECT_EQ(bins[4].count, 1U);
    EXPECT_EQ(bins[9].count, 1U);
    EXPECT_DOUBLE_EQ(bins[0].mean_probability, 0.05);
    EXPECT_DOUBLE_EQ(bins[0].positive_share, 0.5);
    EXPECT_TRUE(std::isnan(bins[2].mean_probability));
    // The sum of share of samples x gap over the bins: 2/5 |.5 - .05| + 1/5 |1 - .1| + 1/5 |0 - .5| + 0 = 0.46.
    EXPECT_NEAR(expected_calibration_error(bins), 0.46, 1e-9);
}

TEST(Reliability, ForecastsThatComeTrueAreCalibratedAndSharpenedOnesAreNot) {
    const Forecasts forecasts = drawn_probabilities(20000);
    EXPECT_LT(error_of(forecasts), 0.01);
    EXPECT_GT(error_of(heated(forecasts, 0.3)), 0.1);
    EXPECT_TRUE(std::isnan(error_of({})));
}

TEST(Temperature, OneOverTheOtherGivesBackTheProbability) {
    EXPECT_NEAR(at_temperature(at_temperature(0.2, 3.0), 1.0 / 3.0), 0.2, 1e-12);
    EXPECT_NEAR(at_temperature(0.2, 3.0), 1.0 - at_temperature(0.8, 3.0), 1e-12);
    EXPECT_GT(at_temperature(0.0, 1.0), 0.0);
}

TEST(Temperature, FittedUndoesTheHeating) {
    const Forecasts forecasts = drawn_probabilities(20000);
    const double own = fitted_temperature(forecasts.probabilities, forecasts.positive);
    EXPECT_NEAR(own, 1.0, 0.03);
    for (const double temperature : {0.5, 2.0, 5.0}) {
        const Forecasts changed = heated(forecasts, temperature);
        EXPECT_NEAR(fitted_temperature(changed.probabilities, changed.positive), own / temperature, 1e-6 / temperature);
    }
}

TEST(Temperature, FittedIsTheBestOfItsNeighbours) {
    Forecasts forecasts = heated(drawn_probabilities(500), 0.4);
    const double best = fitted_temperature(forecasts.probabilities, forecasts.positive);
    const double least = negative_log_likelihood(heated(forecasts, best));
    EXPECT_LT(least, negative_log_likelihood(heated(forecasts, 1.05 * best)));
    EXPECT_LT(least, negative_log_likelihood(heated(forecasts, 0.95 * best)));
    EXPECT_EQ(fitted_temperature({}, {}), 1.0);
}

}  // namespace
}  // namespace ddtool

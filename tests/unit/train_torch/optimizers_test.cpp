#include "train/torch/optimizers.hpp"

#include <gtest/gtest.h>

#include "ddtool/base/error.hpp"

namespace ddtool::train_torch {
namespace {

TEST(LearningRate, RisesLinearlyThenFallsToItsFinalShare) {
    const train::OptimizerSettings settings{.learning_rate = 0.1, .warm_up_share = 0.2, .final_rate_share = 0.01};
    constexpr std::size_t steps = 100;
    EXPECT_DOUBLE_EQ(learning_rate(settings, 9, steps), 0.05);
    EXPECT_DOUBLE_EQ(learning_rate(settings, 19, steps), 0.1);
    EXPECT_NEAR(learning_rate(settings, 99, steps), 0.001, 1e-12);
    for (std::size_t step = 20; step < steps; ++step) {
        EXPECT_LT(learning_rate(settings, step, steps), learning_rate(settings, step - 1, steps)) << step;
    }
}

/// Every optimiser must move the parameter of a parabola towards its minimum.
class Descent : public testing::TestWithParam<const char*> {};

TEST_P(Descent, FindsTheLowestPoint) {
    torch::Tensor x = torch::tensor({3.0}, torch::requires_grad());
    const auto optimizer = make_optimizer({.name = GetParam(), .learning_rate = 0.05, .weight_decay = 0.0}, {x});
    for (int step = 0; step < 300; ++step) {
        optimizer->zero_grad();
        (x - 1.0).square().sum().backward();
        optimizer->step();
    }
    EXPECT_NEAR(x.item<double>(), 1.0, 0.05);
}

TEST_P(Descent, StandsStillAtRateZero) {
    torch::Tensor x = torch::tensor({3.0}, torch::requires_grad());
    const auto optimizer = make_optimizer({.name = GetParam()}, {x});
    set_learning_rate(*optimizer, 0.0);
    x.square().sum().backward();
    optimizer->step();
    EXPECT_EQ(x.item<double>(), 3.0);
}

INSTANTIATE_TEST_SUITE_P(Optimizers, Descent, testing::Values("adam", "adamw", "rmsprop"),
                         [](const auto& info) { return std::string(info.param); });

TEST(Optimizers, AnUnknownNameIsNamed) { EXPECT_THROW(make_optimizer({.name = "sgd"}, {}), UsageError); }

}  // namespace
}  // namespace ddtool::train_torch

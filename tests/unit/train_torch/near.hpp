#pragma once

#include <gmock/gmock.h>
#include <torch/torch.h>

#include <iomanip>

namespace ddtool::train_torch {

/// Succeeds if the shapes are equal and no value differs from the expected one by more than the tolerance.
inline testing::AssertionResult near(const torch::Tensor& actual, const torch::Tensor& expected, double tolerance) {
    if (actual.sizes() != expected.sizes()) {
        return testing::AssertionFailure() << actual.sizes() << " instead of " << expected.sizes();
    }
    const double difference = (actual - expected).abs().max().item<double>();
    if (difference <= tolerance) {
        return testing::AssertionSuccess();
    }
    return testing::AssertionFailure() << std::setprecision(6) << "differ by " << difference << ":\n"
                                       << actual << "\ninstead of\n"
                                       << expected;
}

}  // namespace ddtool::train_torch

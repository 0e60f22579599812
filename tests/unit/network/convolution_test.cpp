#include "network/convolution.hpp"

#include <algorithm>

#include "dd_weights.hpp"
#include "near.hpp"

namespace ddtool::network {
namespace {

/// Relative to the largest value, which shows the size of the terms that were rounded.
constexpr double relative_tolerance = 1e-5;

double tolerance_for(const naive::Values& expected) {
    return relative_tolerance * std::max(*std::ranges::max_element(expected), -*std::ranges::min_element(expected));
}

struct ConvolutionCase {
    std::size_t inputs;
    std::size_t side;
    ConvolutionRow row;
};

class ConvolutionOf : public testing::TestWithParam<ConvolutionCase> {
protected:
    ConvolutionOf() {
        drawn_.add_convolution("layer", static_cast<std::int64_t>(row_.channels),
                               static_cast<std::int64_t>(in_.channels), static_cast<std::int64_t>(row_.kernel_px));
    }
    [[nodiscard]] naive::Map expected() const {
        return naive::convolution(drawn_.tensors, "layer", in_, row_.channels, row_.kernel_px, row_.stride);
    }
    [[nodiscard]] Convolution layer(const ConvolutionRow& row) const {
        NamedWeights weights(drawn_.tensors);
        return {weights, "layer", {in_.side, in_.channels}, row};
    }

    ConvolutionRow row_ = GetParam().row;
    naive::Map in_{GetParam().inputs, GetParam().side,
                   doubles(drawn_floats(GetParam().inputs* GetParam().side* GetParam().side, 3))};
    MapShape out_ = shape_after(row_, {in_.side, in_.channels});
    test::DrawnWeights drawn_{2};
};

TEST_P(ConvolutionOf, IsThatOfItsDefinition) {
    Convolution own = layer(row_);
    expect_near(planar(own.run(bordered(in_).data()), out_).data(), expected().values,
                tolerance_for(expected().values));
}

TEST_P(ConvolutionOf, AddsTheSkipBeforeReLU) {
    ConvolutionRow row = row_;
    row.relu = true;
    Convolution own = layer(row);
    naive::Map skip = expected();
    skip.values = doubles(drawn_floats(skip.values.size(), 4));
    const naive::Values sum = naive::relu(naive::sum(expected().values, skip.values));
    expect_near(planar(own.run(bordered(in_).data(), bordered(skip).data()), out_).data(), sum, tolerance_for(sum));
}

TEST_P(ConvolutionOf, LeavesTheBorderZero) {
    Convolution own = layer(row_);
    const float* const map = own.run(bordered(in_).data());
    const std::vector<float> values(map, map + out_.size());
    const naive::Map inside{out_.channels, out_.side, doubles(planar(map, out_))};
    EXPECT_EQ(values, bordered(inside));
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, ConvolutionOf,
    testing::Values(ConvolutionCase{16, 7, {.channels = 16}}, ConvolutionCase{16, 8, {.channels = 32, .stride = 2}},
                    ConvolutionCase{32, 8, {.channels = 16}}, ConvolutionCase{48, 4, {.channels = 32}},
                    ConvolutionCase{64, 12, {.channels = 64}}, ConvolutionCase{64, 7, {.channels = 64}},
                    ConvolutionCase{48, 7, {.channels = 16, .stride = 2}},
                    ConvolutionCase{32, 5, {.channels = 16, .kernel_px = 1}},
                    ConvolutionCase{16, 6, {.channels = 32, .kernel_px = 1, .stride = 2}},
                    ConvolutionCase{16, 1, {.channels = 16}}));

}  // namespace
}  // namespace ddtool::network

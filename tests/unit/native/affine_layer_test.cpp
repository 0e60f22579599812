#include "native/affine_layer.hpp"

#include "dd_weights.hpp"
#include "near.hpp"

namespace ddtool::native {
namespace {

constexpr double tolerance = 5e-6;

struct ConvolutionCase {
    std::size_t inputs;
    std::size_t side;
    ConvolutionRow row;
};

class Convolution : public testing::TestWithParam<ConvolutionCase> {
protected:
    Convolution() {
        drawn_.add_convolution("layer", static_cast<std::int64_t>(row_.channels),
                               static_cast<std::int64_t>(in_.channels), static_cast<std::int64_t>(row_.kernel_px));
    }
    [[nodiscard]] naive::Map expected() const {
        return naive::convolution(drawn_.tensors, "layer", in_, row_.channels, row_.kernel_px, row_.stride);
    }
    [[nodiscard]] AffineLayer layer(const ConvolutionRow& row) const {
        NamedWeights weights(drawn_.tensors);
        return convolution(weights, "layer", {in_.side, in_.channels}, row);
    }

    ConvolutionRow row_ = GetParam().row;
    naive::Map in_{GetParam().inputs, GetParam().side,
                   doubles(drawn_floats(GetParam().inputs* GetParam().side* GetParam().side, 3))};
    MapShape out_ = shape_after(row_, {in_.side, in_.channels});
    test::DrawnWeights drawn_{2};
};

TEST_P(Convolution, IsThatOfItsDefinition) {
    AffineLayer own = layer(row_);
    expect_near(planar(own.run(bordered(in_).data()), out_).data(), expected().values, tolerance);
}

TEST_P(Convolution, AddsTheSkipBeforeReLU) {
    ConvolutionRow row = row_;
    row.relu = true;
    AffineLayer own = layer(row);
    naive::Map skip = expected();
    skip.values = doubles(drawn_floats(skip.values.size(), 4));
    const naive::Values sum = naive::relu(naive::sum(expected().values, skip.values));
    expect_near(planar(own.run(bordered(in_).data(), bordered(skip).data()), out_).data(), sum, tolerance);
}

TEST_P(Convolution, LeavesTheBorderZero) {
    AffineLayer own = layer(row_);
    const float* const map = own.run(bordered(in_).data());
    const std::vector<float> values(map, map + out_.size());
    const naive::Map inside{out_.channels, out_.side, doubles(planar(map, out_))};
    EXPECT_EQ(values, bordered(inside));
}

INSTANTIATE_TEST_SUITE_P(Shapes, Convolution,
                         testing::Values(ConvolutionCase{16, 7, {.channels = 16}},
                                         ConvolutionCase{16, 8, {.channels = 32, .stride = 2}},
                                         ConvolutionCase{48, 7, {.channels = 16, .stride = 2}},
                                         ConvolutionCase{32, 5, {.channels = 16, .kernel_px = 1}},
                                         ConvolutionCase{16, 6, {.channels = 32, .kernel_px = 1, .stride = 2}},
                                         ConvolutionCase{16, 1, {.channels = 16}}));

TEST(Linear, IsThatOfItsDefinition) {
    test::DrawnWeights drawn(5);
    drawn.add_linear("layer", 48, 20);
    const std::vector<float> in = drawn_floats(7 * 20, 6);
    NamedWeights weights(drawn.tensors);
    AffineLayer own = linear(weights, "layer", {.inputs = 20, .outputs = 48}, packed_tokens(7, 20));
    expect_near(own.run(in.data()), naive::linear(drawn.tensors, "layer", doubles(in), 20), tolerance);
}

}  // namespace
}  // namespace ddtool::native

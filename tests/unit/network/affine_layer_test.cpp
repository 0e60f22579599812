#include "network/affine_layer.hpp"

#include "dd_weights.hpp"
#include "near.hpp"

namespace ddtool::network {
namespace {

constexpr double tolerance = 5e-6;

TEST(Linear, IsThatOfItsDefinition) {
    test::DrawnWeights drawn(5);
    drawn.add_linear("layer", 48, 20);
    const std::vector<float> in = drawn_floats(7 * 20, 6);
    NamedWeights weights(drawn.tensors);
    AffineLayer own = linear(weights, "layer", {.inputs = 20, .outputs = 48}, packed_tokens(7, 20));
    expect_near(own.run(in.data()), naive::linear(drawn.tensors, "layer", doubles(in), 20), tolerance);
}

}  // namespace
}  // namespace ddtool::network

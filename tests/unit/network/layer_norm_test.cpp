#include "network/layer_norm.hpp"

#include "dd_weights.hpp"
#include "near.hpp"

namespace ddtool::network {
namespace {

TEST(LayerNorm, IsThatOfItsDefinition) {
    test::DrawnWeights drawn(10);
    drawn.add_layer_norm("norm", 24);
    NamedWeights weights(drawn.tensors);
    LayerNorm own(weights, "norm", 3, 24);
    std::vector<float> in = drawn_floats(3 * 24, 11);
    std::fill(in.begin(), in.begin() + 24, 2.0F);  // a token whose variance is 0
    expect_near(own.run(in.data()), naive::layer_norm(drawn.tensors, "norm", doubles(in)), 2e-6);
}

}  // namespace
}  // namespace ddtool::network

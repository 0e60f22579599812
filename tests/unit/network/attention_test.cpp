#include "network/attention.hpp"

#include "near.hpp"

namespace ddtool::network {
namespace {

constexpr std::size_t tokens = 19;
constexpr std::size_t width = 64;

TEST(Attention, IsThatOfItsDefinition) {
    const std::vector<float> in = drawn_floats(tokens * 3 * width, 12);
    for (const std::size_t heads : {1U, 2U, 4U}) {
        Attention own(tokens, width, heads);
        expect_near(own.run(in.data()), naive::attention(doubles(in), width, heads), 5e-6);
    }
}

TEST(Attention, OfEqualTokensIsTheirValue) {
    const std::vector<float> token = drawn_floats(3 * width, 13);
    std::vector<float> in;
    for (std::size_t index = 0; index < tokens; ++index) {
        in.insert(in.end(), token.begin(), token.end());
    }
    Attention own(tokens, width, 2);
    expect_near(own.run(in.data()) + 5 * width, {token.begin() + 2 * width, token.end()}, 1e-6);
}

}  // namespace
}  // namespace ddtool::network

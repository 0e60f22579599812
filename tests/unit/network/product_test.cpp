#include "network/product.hpp"

#include <algorithm>

#include "near.hpp"

namespace ddtool::network {
namespace {

constexpr std::size_t outputs = 2 * block_width;
constexpr Window window{.rows = 3, .length = 5, .row_step = 11};
constexpr std::size_t points = 23;  // not a multiple of either kernel's tile

/// Windows that overlap, gaps between the outputs of the points, and all options of a product at once.
struct Example {
    std::vector<float> in = drawn_floats(200, 1);
    std::vector<float> weights = drawn_floats(window.inputs() * outputs, 2);
    std::vector<float> bias = drawn_floats(outputs, 3);
    std::vector<float> skip = drawn_floats(points * (outputs + 3), 4);
    std::vector<std::size_t> from;
    std::vector<std::size_t> to;

    Example() {
        for (std::size_t point = 0; point < points; ++point) {
            from.push_back(7 * point);
            to.push_back((outputs + 3) * point);
        }
    }

    [[nodiscard]] std::vector<float> run(void (*kernel)(const Product&)) const {
        std::vector<float> out(skip.size(), -1.0F);
        kernel({.in = in.data(),
                .from = from,
                .window = window,
                .weights = {.first = weights.data(), .block_step = window.inputs() * block_width},
                .outputs = outputs,
                .bias = bias.data(),
                .skip = skip.data(),
                .relu = true,
                .out = out.data(),
                .to = to});
        return out;
    }

    /// The sum in the order of the inputs, as the header defines it.
    [[nodiscard]] float expected(std::size_t point, std::size_t output) const {
        const std::size_t block = output / block_width;
        float sum = bias[output];
        for (std::size_t input = 0; input < window.inputs(); ++input) {
            const std::size_t place = from[point] + input / window.length * window.row_step + input % window.length;
            sum += in[place] * weights[(block * window.inputs() + input) * block_width + output % block_width];
        }
        return std::max(sum + skip[to[point] + output], 0.0F);
    }

    [[nodiscard]] std::vector<float> expected() const {
        std::vector<float> all(skip.size(), -1.0F);
        for (std::size_t point = 0; point < points; ++point) {
            for (std::size_t output = 0; output < outputs; ++output) {
                all[to[point] + output] = expected(point, output);
            }
        }
        return all;
    }
};

TEST(Product, IsTheSumInOrderToTheLastBit) {
    const Example example;
    EXPECT_EQ(example.run(multiply), example.expected());
}

TEST(Product, IsTheSameBytesInLanesOfEveryWidth) {
    const Example example;
    EXPECT_EQ(example.run(multiply_in_lanes), example.expected());
    EXPECT_EQ(example.run(multiply_in_wide_lanes), example.expected());
}

}  // namespace
}  // namespace ddtool::network

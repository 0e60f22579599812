#include <gtest/gtest.h>

#include "counted_allocations.hpp"
#include "dd_weights.hpp"
#include "network/dd_network.hpp"

namespace ddtool::native {
namespace {

TEST(DDNetwork, AllocatesNothingWhenItRuns) {
    constexpr std::size_t size_px = 64;
    const native::DDModelTable& table = native::ddmodel_lite_table();
    NamedWeights weights(test::drawn_dd_weights(table, size_px));
    DDNetwork network(weights, table, size_px);
    const std::vector<float> image(size_px * size_px, 1.0F);
    const int before = test::allocations;
    EXPECT_GT(before, 0);
    (void)network.run(image);
    EXPECT_EQ(test::allocations, before);
}

}  // namespace
}  // namespace ddtool::native

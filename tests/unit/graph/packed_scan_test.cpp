#include "graph/packed_scan.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "ddtool/base/random.hpp"

namespace ddtool::graph {
namespace {

TEST(PackedScan, ReadsBackWhatWasPacked) {
    RandomStream random({7});
    ScanPoints points;
    points.origin_m = {0.2, -0.1};
    points.joined.push_back({{-0.3, 0.0}, 150});
    std::int32_t order = 0;
    for (int i = 0; i < 300; ++i) {
        const double normal = random.uniform(-3.14, 3.14);
        points.x_m.push_back(static_cast<float>(random.uniform(-40.0, 40.0)));
        points.y_m.push_back(static_cast<float>(random.uniform(-40.0, 40.0)));
        points.normal_x.push_back(static_cast<float>(std::cos(normal)));
        points.normal_y.push_back(static_cast<float>(std::sin(normal)));
        points.along_weight.push_back(static_cast<float>(random.uniform()));
        order += 1 + static_cast<std::int32_t>(random.index(3));
        points.order.push_back(order);
    }
    const PackedScan packed(points);
    const ScanPoints read = packed.unpacked();
    ASSERT_EQ(read.size(), points.size());
    EXPECT_EQ(read.order, points.order);
    EXPECT_EQ(read.origin_m, points.origin_m);
    ASSERT_EQ(read.joined.size(), 1U);
    EXPECT_EQ(read.joined[0].begin, 150U);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_NEAR(read.x_m[i], points.x_m[i], 1e-3);
        EXPECT_NEAR(read.y_m[i], points.y_m[i], 1e-3);
        EXPECT_NEAR(read.normal_x[i], points.normal_x[i], 2e-4);
        EXPECT_NEAR(read.normal_y[i], points.normal_y[i], 2e-4);
        EXPECT_NEAR(read.along_weight[i], points.along_weight[i], 2.1e-3);
    }
    EXPECT_LT(packed.bytes(), 9 * points.size() + 200);
}

TEST(PackedScan, AnEmptyScanStaysEmpty) {
    EXPECT_EQ(PackedScan(ScanPoints{}).unpacked().size(), 0U);
    EXPECT_EQ(PackedScan().unpacked().size(), 0U);
}

}  // namespace
}  // namespace ddtool::graph

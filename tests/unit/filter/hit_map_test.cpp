#include "ddtool/filter/hit_map.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "ddtool/base/random.hpp"

namespace ddtool {
namespace {

constexpr double hit_cell_m = 0.05;

/// The same map as a list of end points for each cell, and the nearest mean by looking at all nine cells.
class PlainMap {
public:
    void add(Point2 end_m) { ends_[cell_of(end_m)].push_back(end_m); }

    [[nodiscard]] double nearest_m2(Point2 end_m) const {
        const auto [x, y] = cell_of(end_m);
        double nearest = std::numeric_limits<double>::infinity();
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                if (const auto found = ends_.find({x + dx, y + dy}); found != ends_.end()) {
                    Point2 mean;
                    for (const Point2& each : found->second) {
                        mean.x_m += each.x_m / static_cast<double>(found->second.size());
                        mean.y_m += each.y_m / static_cast<double>(found->second.size());
                    }
                    const double distance = std::hypot(mean.x_m - end_m.x_m, mean.y_m - end_m.y_m);
                    nearest = std::min(nearest, distance * distance);
                }
            }
        }
        return nearest;
    }

private:
    using PlainCell = std::pair<long, long>;
    static PlainCell cell_of(Point2 end_m) {
        return {std::lround(end_m.x_m / hit_cell_m), std::lround(end_m.y_m / hit_cell_m)};
    }

    std::map<PlainCell, std::vector<Point2>> ends_;
};

Point2 drawn_within(double half_m, RandomStream& random) {
    return {random.uniform(-half_m, half_m), random.uniform(-half_m, half_m)};
}

/// Points about the origin, so that cells and patches of negative numbers and the borders of patches are among them.
TEST(HitMap, FindsTheNearestMeanOfTheNineCells) {
    RandomStream random{1};
    HitMap map(hit_cell_m);
    PlainMap plain;
    map.reserve({-2.0, -2.0}, {2.0, 2.0});
    for (int i = 0; i < 2'000; ++i) {
        const Point2 end = drawn_within(2.0, random);
        map.add(end);
        plain.add(end);
    }
    int misses = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Point2 end = drawn_within(2.2, random);
        const double expected = plain.nearest_m2(end);
        const double found = map.nearest_m2(end);
        if (std::isinf(expected)) {
            ++misses;
            ASSERT_LT(found, 0.0) << end.x_m << " " << end.y_m;
        } else {
            ASSERT_NEAR(found, expected, 1e-7) << end.x_m << " " << end.y_m;
        }
    }
    EXPECT_GT(misses, 100);
}

TEST(HitMap, ACellReachesHalfItsSizeToEachSideOfAMultiple) {
    HitMap map(hit_cell_m);
    map.reserve({-1.0, -1.0}, {1.0, 1.0});
    map.add({0.024, 0.0});
    EXPECT_GE(map.nearest_m2({0.074, 0.0}), 0.0);  // of the next cell
    EXPECT_LT(map.nearest_m2({0.076, 0.0}), 0.0);  // of the one after it
    EXPECT_GE(map.nearest_m2({-0.074, 0.0}), 0.0);
    EXPECT_LT(map.nearest_m2({-0.076, 0.0}), 0.0);
}

TEST(HitMap, GrowsAndKeepsWhatItHas) {
    HitMap map(hit_cell_m);
    map.reserve({0.0, 0.0}, {0.1, 0.1});
    map.add({0.05, 0.05});
    for (const double far_m : {10.0, -30.0}) {
        map.reserve({std::min(far_m, 0.0), std::min(far_m, 0.0)}, {std::max(far_m, 0.0), std::max(far_m, 0.0)});
        map.add({far_m, far_m});
    }
    for (const double at_m : {0.05, 10.0, -30.0}) {
        EXPECT_NEAR(map.nearest_m2({at_m, at_m}), 0.0, 1e-9);
    }
    EXPECT_LT(map.nearest_m2({5.0, 5.0}), 0.0);
    EXPECT_LT(map.nearest_m2({1e12, -1e12}), 0.0);
}

TEST(HitMap, CopiesGoTheirOwnWays) {
    HitMap one(hit_cell_m);
    one.reserve({-1.0, -1.0}, {1.0, 1.0});
    one.add({0.0, 0.0});
    HitMap two = one;
    two.add({0.5, 0.5});
    EXPECT_LT(one.nearest_m2({0.5, 0.5}), 0.0);
    EXPECT_GE(two.nearest_m2({0.5, 0.5}), 0.0);
    two.add({0.02, 0.0});
    EXPECT_EQ(one.nearest_m2({0.0, 0.0}), 0.0);
    EXPECT_NEAR(two.nearest_m2({0.0, 0.0}), 1e-4, 1e-9);
}

/// Full patches have one slot for each cell.
TEST(HitMap, EveryCellOfAPatchCanHaveHits) {
    HitMap map(hit_cell_m);
    map.reserve({-1.0, -1.0}, {2.0, 2.0});
    for (int x = 0; x < 2 * HitPatch::size_cells; ++x) {
        for (int y = 0; y < 2 * HitPatch::size_cells; ++y) {
            map.add({hit_cell_m * x, hit_cell_m * y});
        }
    }
    for (int x = 0; x < 2 * HitPatch::size_cells; ++x) {
        for (int y = 0; y < 2 * HitPatch::size_cells; ++y) {
            ASSERT_NEAR(map.nearest_m2({hit_cell_m * x, hit_cell_m * y}), 0.0, 1e-12) << x << " " << y;
        }
    }
}

TEST(HitMap, IsCountedWithTheMapsAndGivesEverythingBack) {
    const std::size_t before = MapBytes::live.load();
    {
        HitMap map(hit_cell_m);
        map.reserve({0.0, 0.0}, {1.0, 1.0});
        map.add({0.2, 0.2});
        const std::size_t one = MapBytes::live.load() - before;
        EXPECT_GE(one, sizeof(HitPatch));
        const HitMap copy = map;
        EXPECT_LT(MapBytes::live.load() - before, 2 * one);
    }
    EXPECT_EQ(MapBytes::live.load(), before);
}

}  // namespace
}  // namespace ddtool

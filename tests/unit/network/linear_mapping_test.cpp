#include "ddtool/network/linear_mapping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "swarm/rules.hpp"
#include "swarms.hpp"

namespace ddtool {
namespace {

constexpr std::size_t mapped_size_px = 224;

std::vector<Point2> uniform_points(std::size_t count, std::uint64_t seed, double width_m, double height_m) {
    RandomStream random({seed});
    std::vector<Point2> points(count);
    for (Point2& point : points) {
        point = {random.uniform(-width_m / 2.0, width_m / 2.0), random.uniform(-height_m / 2.0, height_m / 2.0)};
    }
    return points;
}

std::vector<ImagePixel> places_of(std::span<const Point2> points, const ImageSettings& settings = {}) {
    std::vector<ImagePixel> places;
    map_to_pixels(points, settings.canvas_m, settings, places);
    return places;
}

double signed_difference(std::size_t a, std::size_t b) { return static_cast<double>(a) - static_cast<double>(b); }

TEST(AxisMapping, CutsTheCanvasIntoEqualPixels) {
    const AxisMapping axis(0.0, 0.0, 8.0, 16);
    for (std::size_t pixel = 0; pixel < 16; ++pixel) {
        const double left_m = -4.0 + 0.5 * static_cast<double>(pixel);
        EXPECT_EQ(axis.pixel(left_m), pixel);
        EXPECT_EQ(axis.pixel(left_m + 0.499), pixel);
    }
}

TEST(AxisMapping, HasItsEdgesInsideAndNothingBeyond) {
    const AxisMapping axis(-20.0, 30.0, 8.0, 16);
    EXPECT_EQ(axis.pixel(1.0), 0U);
    EXPECT_EQ(axis.pixel(9.0), 15U);
    EXPECT_EQ(axis.pixel(1.0 - 1e-12), std::nullopt);
    EXPECT_EQ(axis.pixel(9.0 + 1e-12), std::nullopt);
    EXPECT_EQ(axis.pixel(std::nan("")), std::nullopt);
}

TEST(LinearMapping, HasOneMetricScaleInBothDimensionsWhateverTheShape) {
    constexpr double px_per_m = mapped_size_px / 10.0;
    for (const auto& [width_m, height_m] : {std::pair{9.0, 0.1}, {0.1, 9.0}, {0.01, 0.02}, {5.0, 5.0}}) {
        const std::vector<Point2> points = uniform_points(50, 3, width_m, height_m);
        const std::vector<ImagePixel> places = places_of(points);
        ASSERT_EQ(places.size(), points.size());
        for (std::size_t i = 1; i < points.size(); ++i) {
            const double columns = signed_difference(places[i].column, places[0].column);
            const double rows = signed_difference(places[0].row, places[i].row);
            EXPECT_LT(std::abs(columns - px_per_m * (points[i].x_m - points[0].x_m)), 1.0);
            EXPECT_LT(std::abs(rows - px_per_m * (points[i].y_m - points[0].y_m)), 1.0);
        }
    }
}

TEST(LinearMapping, PutsTheBoundingBoxInTheMiddle) {
    const std::vector<ImagePixel> places = places_of(uniform_points(50, 4, 6.0, 2.0));
    const auto [left, right] = std::minmax_element(
        places.begin(), places.end(), [](const ImagePixel& a, const ImagePixel& b) { return a.column < b.column; });
    const auto [top, bottom] = std::minmax_element(
        places.begin(), places.end(), [](const ImagePixel& a, const ImagePixel& b) { return a.row < b.row; });
    EXPECT_EQ(left->column + right->column, mapped_size_px - 1);
    EXPECT_EQ(top->row + bottom->row, mapped_size_px - 1);
}

TEST(LinearMapping, LosesExactlyTheParticlesOutsideOfTheCanvas) {
    std::vector<Point2> points = uniform_points(500, 5, 30.0, 16.0);
    points.push_back({-15.0, -8.0});
    points.push_back({15.0, 8.0});  // these two are the extremes, so the canvas is centred on the origin
    const auto on_canvas = [](const Point2& point) {
        return std::max(std::abs(point.x_m), std::abs(point.y_m)) <= 5.0;
    };
    std::vector<ImagePixel> expected;
    for (const Point2& point : points) {
        if (on_canvas(point)) {
            expected.push_back({mapped_size_px - 1 - static_cast<std::size_t>((point.y_m + 5.0) * 22.4),
                                static_cast<std::size_t>((point.x_m + 5.0) * 22.4)});
        }
    }
    ASSERT_GT(expected.size(), 50U);
    EXPECT_EQ(places_of(points), expected);
}

TEST(LinearMapping, SwitchedOffHandsOverTheCoordinatesAsTheyAre) {
    const ImageSettings raw{.linear_mapping = false};
    const std::vector<Point2> points{{3.2, -1.5}, {3.7, -1.1}, {-0.1, 100.0}, {0.0, 112.5}};
    const std::vector<ImagePixel> expected{{113, 115}, {113, 115}, {11, 111}};
    EXPECT_EQ(places_of(points, raw), expected) << "a metre a pixel from the middle, what is outside dropped";
    EXPECT_EQ(places_of(std::span(points).first(1), raw), std::vector<ImagePixel>{expected[0]}) << "no centring";
}

TEST(Coordinates, LeaveOutWhatIsNotFinite) {
    const double inf = std::numeric_limits<double>::infinity();
    std::vector<Point2> points;
    coordinates(test::swarm_at({{1.0, 2.0}, {std::nan(""), 0.0}, {0.0, -inf}, {3.0, 4.0}}), {.swarm = Swarm::absolute},
                points);
    EXPECT_EQ(points, (std::vector<Point2>{{1.0, 2.0}, {3.0, 4.0}}));
}

TEST(CanvasSide, FollowsThePredictionForTheStepSwarmAlone) {
    const std::vector<SnapshotParticle> swarm = test::normal_swarm(100, 7, {});
    const double predicted_m = spread_m(swarm, &SnapshotParticle::predicted_motion);
    EXPECT_EQ(canvas_side_m(swarm, {}), 10.0);
    EXPECT_EQ(canvas_side_m(swarm, {.swarm = Swarm::step, .step_canvas_spreads = 6.0}), 6.0 * predicted_m);
    EXPECT_EQ(canvas_side_m({}, {.swarm = Swarm::step}), 0.1) << "nothing predicted";
    EXPECT_EQ(canvas_side_m(swarm, {.swarm = Swarm::step, .step_canvas_spreads = 0.0, .step_canvas_min_m = 1.0}), 1.0);
}

}  // namespace
}  // namespace ddtool

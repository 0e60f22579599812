#include "report/axes.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace ddtool::report {
namespace {

constexpr Colour red{255, 0, 0};

cv::Mat3b drawn(const Axes& axes) {
    Canvas canvas(400, 300);
    axes.draw(canvas, {0, 0, 400, 300});
    return canvas.page();
}

cv::Mat1b red_pixels(const cv::Mat3b& page) {
    cv::Mat1b mask;
    cv::inRange(page, cv::Scalar(0, 0, 200), cv::Scalar(80, 80, 255), mask);
    return mask;
}

/// The smallest box that contains all red pixels.
cv::Rect red_box(const Axes& axes) { return cv::boundingRect(red_pixels(drawn(axes))); }

Axes unit_square() {
    Axes axes;
    axes.x_range(0, 1).y_range(0, 1);
    return axes;
}

TEST(View, MapsTheCornersOfItsRanges) {
    const View view{{-1.0, 3.0}, {10.0, 20.0}, 200.0, 100.0};
    EXPECT_EQ(view.pixel(-1.0, 10.0).x_px, 0.0);
    EXPECT_EQ(view.pixel(-1.0, 10.0).y_px, 100.0) << "up is up";
    EXPECT_EQ(view.pixel(3.0, 20.0).x_px, 200.0);
    EXPECT_EQ(view.pixel(3.0, 20.0).y_px, 0.0);
}

TEST(Axes, ShowMoreToTheRightAndHigherUp) {
    const std::vector<double> low{0.2};
    const std::vector<double> high{0.8};
    const cv::Rect there = red_box(unit_square().scatter(low, low, {"", red, 3.0}));
    const cv::Rect right = red_box(unit_square().scatter(high, low, {"", red, 3.0}));
    const cv::Rect above = red_box(unit_square().scatter(low, high, {"", red, 3.0}));
    EXPECT_GT(right.x, there.x + 100);
    EXPECT_EQ(right.y, there.y);
    EXPECT_LT(above.y, there.y - 80);
    EXPECT_EQ(above.x, there.x);
}

TEST(Axes, LookTheSameForScaledData) {
    const std::vector<double> x{1.0, 2.0, 4.0};
    const std::vector<double> y{-1.0, 3.0, 1.0};
    const std::vector<double> ten_x{10.0, 20.0, 40.0};
    Axes axes;
    Axes scaled;
    EXPECT_EQ(red_box(axes.line(x, y, {"", red, 2.0})), red_box(scaled.line(ten_x, y, {"", red, 2.0})));
}

TEST(Axes, KeepTheirDataInTheirFrame) {
    const std::vector<double> far{-1e12, 0.5, 1e12};
    const std::vector<double> level{0.5, 0.5, 0.5};
    const cv::Rect across = red_box(unit_square().line(far, level, {"", red, 2.0}));
    const cv::Rect upright = red_box(unit_square().line(level, far, {"", red, 2.0}));
    EXPECT_GT(across.x, 20) << "the ticks on the left stay free";
    EXPECT_LT(across.br().x, 395);
    EXPECT_GT(across.width, 300);
    EXPECT_LT(upright.br().y, 285) << "the ticks below stay free";
}

TEST(Axes, LeaveAGapWhereANumberIsMissing) {
    const std::vector<double> x{0.0, 0.4, 0.5, 0.6, 1.0};
    const std::vector<double> y{0.5, 0.5, std::nan(""), 0.5, 0.5};
    cv::Mat labels;
    const Axes axes = unit_square().line(x, y, {"", red, 2.0});
    EXPECT_EQ(cv::connectedComponents(red_pixels(drawn(axes)), labels) - 1, 2);
}

TEST(Axes, WithEqualAspectShowASquareAsASquare) {
    const std::vector<double> x{0.0, 1.0, 1.0, 0.0, 0.0};
    const std::vector<double> y{0.0, 0.0, 1.0, 1.0, 0.0};
    Axes stretched;
    EXPECT_GT(red_box(stretched.line(x, y, {"", red, 1.0})).width, 300);
    Axes equal;
    const cv::Rect box = red_box(equal.equal_aspect().line(x, y, {"", red, 1.0}));
    EXPECT_NEAR(box.width, box.height, 2);
}

TEST(Axes, DrawBarsFromZeroInProportion) {
    const auto bar_of = [](double height) {
        Axes axes;
        axes.y_range(-1.0, 1.0).bars({"a", "b"}, {{"", {height, 0.0}}});
        cv::Mat1b mask;  // colour 0 of the series is blue
        cv::inRange(drawn(axes), cv::Scalar(160, 100, 0), cv::Scalar(190, 130, 10), mask);
        return cv::boundingRect(mask);
    };
    EXPECT_NEAR(bar_of(0.8).height, 2 * bar_of(0.4).height, 2);
    EXPECT_NEAR(bar_of(-0.8).y, bar_of(0.8).br().y, 2);
}

TEST(Axes, CountEveryValueOfAHistogram) {
    std::vector<double> values(10, 0.0);
    values.insert(values.end(), 5, 1.0);
    values.push_back(std::nan(""));
    const auto area_from = [&](const std::vector<double>& sample) {
        Axes axes;
        return cv::countNonZero(red_pixels(drawn(axes.y_range(0, 20).histogram(sample, 2, {"", red, 1.0}))));
    };
    const std::vector<double> twice = [&] {
        std::vector<double> doubled = values;
        doubled.insert(doubled.end(), values.begin(), values.end());
        return doubled;
    }();
    EXPECT_NEAR(area_from(twice), 2 * area_from(values), 0.05 * area_from(twice));
}

TEST(Axes, PutAPictureUnderItsCoordinates) {
    const std::vector<std::uint8_t> left_black{0, 255, 0, 255};
    Axes axes;
    axes.picture({2, 2, 1, left_black}, {0.0, 2.0}, {0.0, 2.0}).x_range(0, 2).y_range(0, 2);
    const cv::Mat3b page = drawn(axes);
    EXPECT_EQ(page(150, 120), cv::Vec3b(0, 0, 0));
    EXPECT_EQ(page(150, 320), cv::Vec3b(255, 255, 255));
}

TEST(Axes, ListLabelledSeriesInTheLegend) {
    const std::vector<double> values{0.0, 1.0};
    Axes labelled = unit_square();
    Axes unlabelled = unit_square();
    const cv::Rect with = red_box(labelled.line(values, values, {"a series", red, 2.0}).y_range(0.5, 1));
    const cv::Rect without = red_box(unlabelled.line(values, values, {"", red, 2.0}).y_range(0.5, 1));
    EXPECT_LT(with.x, without.x) << "the swatch stands at the left end";
}

TEST(Axes, SurviveDataThatShowNothing) {
    const std::vector<double> none;
    const std::vector<double> missing{std::nan("")};
    const std::vector<double> same{2.0, 2.0};
    EXPECT_NO_THROW(drawn(Axes()));
    EXPECT_NO_THROW(drawn(Axes().line(none, none).histogram(none, 3).histogram(missing, 3)));
    EXPECT_NO_THROW(drawn(Axes().equal_aspect().heat_line(same, same, std::vector{0.0, 0.0}, "error")));
    EXPECT_NO_THROW(drawn(Axes().band(same, same, same, red).histogram(same, 3)));
}

}  // namespace
}  // namespace ddtool::report

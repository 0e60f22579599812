#include "report/figure.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "ddtool/base/error.hpp"
#include "scores/trajectory_plot.hpp"
#include "system/atomic_file.hpp"
#include "wandering_path.hpp"

namespace ddtool::report {
namespace {

bool is_white(const cv::Mat3b& pixels) { return cv::countNonZero(pixels.reshape(1) != 255) == 0; }

TEST(Figure, GivesEachAxesItsShareOfThePage) {
    Figure figure({.width_px = 400, .height_px = 400, .row_shares = {3.0, 1.0}, .columns = 2});
    figure.axes(1, 1).title("only here");
    const cv::Mat3b page = figure.render();
    ASSERT_EQ(page.size(), cv::Size(400, 400));
    EXPECT_TRUE(is_white(page.rowRange(0, 298)));
    EXPECT_TRUE(is_white(page.rowRange(300, 400).colRange(0, 198)));
    EXPECT_FALSE(is_white(page.rowRange(300, 400).colRange(200, 400)));
}

TEST(Figure, HasNoAxesBeyondItsLayout) { EXPECT_THROW(Figure().axes(1, 0), std::out_of_range); }

TEST(Figure, IsWrittenAsPng) {
    const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "figure_test.png";
    Figure figure;
    figure.axes().title("a page");
    figure.write_png(path);
    EXPECT_EQ(read_file(path).substr(0, 4), "\x89PNG");
    std::filesystem::remove(path);
    EXPECT_THROW(figure.write_png("/nowhere/at/all.png"), Error);
}

TEST(ErrorFigure, IsAsHighAsThePathNeeds) {
    const Trajectory path = wandering_path(50, 1);
    Trajectory flat = path;
    for (StampedPose& stamped : flat) {
        stamped.pose.y_m *= 0.01;
    }
    const auto height_px = [](const Trajectory& reference) {
        return ate_figure(absolute_trajectory_error(noisy(reference, 2), reference)).render().rows;
    };
    EXPECT_GT(height_px(path), height_px(flat));
}

TEST(ErrorFigure, OfASinglePoseIsDrawn) {
    const Trajectory one{{0, {1.0, 2.0, 3.0}}};
    EXPECT_FALSE(ate_figure(absolute_trajectory_error(one, one)).render().empty());
}

}  // namespace
}  // namespace ddtool::report

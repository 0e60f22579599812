#include "report/montage.hpp"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "ddtool/base/error.hpp"

namespace ddtool::report {
namespace {

constexpr double tile_px = 40.0;

cv::Mat blue_picture(int size_px) { return {size_px, size_px, CV_8UC3, cv::Scalar(255, 0, 0)}; }

MontageRow row_of(std::size_t left, std::size_t right) {
    return {"row", {std::vector<cv::Mat>(left, blue_picture(80)), std::vector<cv::Mat>(right, blue_picture(7))}};
}

/// The blue squares on the page.
std::vector<cv::Rect> tiles_of(const cv::Mat3b& page) {
    cv::Mat1b blue;
    cv::inRange(page, cv::Scalar(250, 0, 0), cv::Scalar(255, 5, 5), blue);
    cv::Mat labels;
    cv::Mat statistics;
    cv::Mat centres;
    std::vector<cv::Rect> tiles;
    for (int label = 1; label < cv::connectedComponentsWithStats(blue, labels, statistics, centres); ++label) {
        const int* box = statistics.ptr<int>(label);
        tiles.emplace_back(box[cv::CC_STAT_LEFT], box[cv::CC_STAT_TOP], box[cv::CC_STAT_WIDTH],
                           box[cv::CC_STAT_HEIGHT]);
    }
    return tiles;
}

TEST(Montage, ShowsEveryPictureAsASquareOfOneSize) {
    const std::vector<cv::Rect> tiles = tiles_of(montage({"a", "b"}, {row_of(3, 1), row_of(1, 2)}, tile_px));
    ASSERT_EQ(tiles.size(), 7U);
    for (const cv::Rect& tile : tiles) {
        EXPECT_NEAR(tile.width, tile_px, 1);
        EXPECT_NEAR(tile.height, tile_px, 1);
    }
}

TEST(Montage, HasItsGroupsInColumnsAndItsRowsBelowEachOther) {
    const std::vector<cv::Rect> tiles = tiles_of(montage({"a", "b"}, {row_of(3, 1), row_of(0, 1)}, tile_px));
    ASSERT_EQ(tiles.size(), 5U);
    EXPECT_EQ(tiles[4].x, tiles[3].x) << "the second group begins after the longest first one";
    EXPECT_GT(tiles[3].x, tiles[2].br().x);
    EXPECT_EQ(tiles[3].y, tiles[0].y);
    EXPECT_GT(tiles[4].y, tiles[0].br().y);
}

TEST(Montage, HasRoomForItsWords) {
    const std::string words(60, 'w');
    EXPECT_GT(montage({words}, {}, tile_px).cols, 300);
    EXPECT_GT(montage({"a"}, {{words, {{}}}}, tile_px).cols, 300);
}

TEST(Montage, RefusesARowWithoutAGroupForEachTitle) {
    EXPECT_THROW(montage({"a", "b", "c"}, {row_of(1, 1)}, tile_px), Error);
}

}  // namespace
}  // namespace ddtool::report

#include "report/map_picture.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <array>

#include "temporary_folder.hpp"

namespace ddtool {
namespace {

struct Pixels {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::uint8_t> bgr;

    [[nodiscard]] std::size_t count(std::array<std::uint8_t, 3> colour) const {
        std::size_t found = 0;
        for (std::size_t i = 0; i < bgr.size(); i += 3) {
            found += std::equal(colour.begin(), colour.end(), bgr.begin() + static_cast<std::ptrdiff_t>(i)) ? 1 : 0;
        }
        return found;
    }
};

Pixels read_png(const std::filesystem::path& file) {
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&header, file.c_str()), 0) << header.message;
    header.format = PNG_FORMAT_BGR;
    Pixels pixels{header.width, header.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(header))};
    EXPECT_NE(png_image_finish_read(&header, nullptr, pixels.bgr.data(), 0, nullptr), 0) << header.message;
    return pixels;
}

Pixels picture_of(const MapRaster& map, const Trajectory& path) {
    const test::TemporaryFolder folder;
    write_map_picture(folder / "map.png", map, path);
    return read_png(folder / "map.png");
}

MapRaster free_map_with_one_wall_cell(std::size_t width, std::size_t height) {
    MapRaster map{.width = width, .height = height, .cell_size_m = 0.05, .origin_m = {-1.0, 2.0}, .cells = {}};
    map.cells.assign(width * height, MapRaster::free);
    map.cells[width * height / 2] = MapRaster::occupied;
    return map;
}

constexpr std::array<std::uint8_t, 3> free_ground{254, 254, 254};
constexpr std::array<std::uint8_t, 3> black{0, 0, 0};
constexpr std::array<std::uint8_t, 3> blue{178, 114, 0};      // the path
constexpr std::array<std::uint8_t, 3> green{115, 158, 0};     // its start
constexpr std::array<std::uint8_t, 3> path_red{30, 50, 213};  // its end

TEST(MapPicture, ShowsACellAsASquareWhereThereIsRoom) {
    const Pixels pixels = picture_of(free_map_with_one_wall_cell(40, 20), {});
    EXPECT_EQ(pixels.count(free_ground), (40U * 20U - 1U) * 25U);
}

TEST(MapPicture, LosesNoWallOfALargeMap) {
    MapRaster map = free_map_with_one_wall_cell(3000, 3000);
    const Pixels with = picture_of(map, {});
    map.cells.assign(map.cells.size(), MapRaster::free);
    const Pixels without = picture_of(map, {});
    EXPECT_GT(with.count(black), without.count(black));  // the remaining black pixels are the scale bar
    EXPECT_LE(with.width, 1300U);
}

TEST(MapPicture, ShowsThePathAlsoBeyondTheMap) {
    const MapRaster map = free_map_with_one_wall_cell(40, 20);
    const Trajectory path{{0, {-0.5, 2.5, 0.0}}, {1, {0.5, 2.5, 0.0}}};
    const Trajectory long_path{{0, {-0.5, 2.5, 0.0}}, {1, {9.5, 2.5, 0.0}}};
    EXPECT_GT(picture_of(map, path).count(blue), 50U);
    EXPECT_GT(picture_of(map, long_path).width, picture_of(map, path).width);
    EXPECT_GT(picture_of(map, long_path).count(blue), 500U);
}

TEST(MapPicture, ShowsStartAndEndWhereTheyAreOnePlace) {
    const Trajectory loop{{0, {-0.5, 2.5, 0.0}}, {1, {0.5, 2.5, 0.0}}, {2, {-0.5, 2.5, 0.0}}};
    const Pixels pixels = picture_of(free_map_with_one_wall_cell(40, 20), loop);
    EXPECT_GT(pixels.count(green), 10U);
    EXPECT_GT(pixels.count(path_red), 10U);
}

TEST(MapPicture, MayBeOfOneCellAndOnePose) {
    MapRaster map = free_map_with_one_wall_cell(1, 1);
    const Pixels pixels = picture_of(map, {{0, {-1.0, 2.0, 0.0}}});
    EXPECT_GT(pixels.count(green), 0U);
}

}  // namespace
}  // namespace ddtool

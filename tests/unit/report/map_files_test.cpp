#include "report/map_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>

#include "random_map.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

/// Reads a map in the same way as map_server and nav2 do in trinary mode.
MapRaster read_map(const std::filesystem::path& folder, const std::string& yaml_name) {
    char image[64] = "";
    double occupied_threshold = 0.0;
    double free_threshold = 0.0;
    MapRaster map;
    const std::string yaml = read_file(folder / yaml_name);
    EXPECT_EQ(std::sscanf(yaml.c_str(),
                          "image: %63s\nmode: trinary\nresolution: %lf\norigin: [%lf, %lf, 0]\nnegate: 0\n"
                          "occupied_thresh: %lf\nfree_thresh: %lf\n",
                          image, &map.cell_size_m, &map.origin_m.x_m, &map.origin_m.y_m, &occupied_threshold,
                          &free_threshold),
              6);
    std::istringstream pgm(read_file(folder / image));
    std::string magic;
    int largest = 0;
    pgm >> magic >> map.width >> map.height >> largest;
    EXPECT_EQ(magic, "P5");
    EXPECT_EQ(largest, 255);
    pgm.get();
    map.cells.resize(map.width * map.height);
    for (std::size_t row = map.height; row-- > 0;) {
        for (std::size_t column = 0; column < map.width; ++column) {
            const double occupancy = (255 - pgm.get()) / 255.0;
            map.cells[row * map.width + column] = occupancy > occupied_threshold ? MapRaster::occupied
                                                  : occupancy < free_threshold   ? MapRaster::free
                                                                                 : MapRaster::unknown;
        }
    }
    EXPECT_TRUE(pgm.good());
    EXPECT_EQ(pgm.get(), std::char_traits<char>::eof());
    return map;
}

TEST(MapFiles, AreReadBackAsMapServersReadThem) {
    for (const auto& [width, height] : {std::pair{1U, 1U}, {7U, 3U}, {40U, 90U}}) {
        const test::TemporaryFolder folder;
        const MapRaster map = test::random_map(width, height);
        write_map_files(folder / "", "floor", map);
        const MapRaster read = read_map(folder / "", "floor.yaml");
        EXPECT_EQ(read.cells, map.cells);
        EXPECT_EQ(read.width, map.width);
        EXPECT_DOUBLE_EQ(read.cell_size_m, map.cell_size_m);
        EXPECT_EQ(read.origin_m, map.origin_m);
    }
}

TEST(MapFiles, NameWhatCannotBeWritten) {
    EXPECT_THAT(test::thrown_text([] { write_map_files("/nowhere", "map", test::random_map(2, 2)); }),
                testing::HasSubstr("/nowhere/map.pgm"));
}

}  // namespace
}  // namespace ddtool

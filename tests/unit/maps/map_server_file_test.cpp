#include "maps/map_server_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <numbers>
#include <string>

#include "maps/any_map.hpp"
#include "maps/pgm_file.hpp"
#include "report/map_files.hpp"
#include "small_map.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::maps {
namespace {

using testing::HasSubstr;

/// A folder with a map of three by two pixels; the upper row is 0, 100, 205, the lower one 254, 130, 255.
class MapServer : public testing::Test {
protected:
    MapServer() {
        write_file(folder_ / "m.pgm", "P5\n# a comment\n3 2\n255\n" + std::string("\x00\x64\xcd\xfe\x82\xff", 6));
    }

    OccupancyGrid read(const std::string& yaml) {
        write_file(folder_ / "m.yaml", yaml);
        return read_map_server(folder_ / "m.yaml").grid;
    }
    std::string refusal(const std::string& yaml) {
        return ddtool::test::thrown_text([&] { read(yaml); });
    }

    ddtool::test::TemporaryFolder folder_;
};

constexpr const char* head = "image: m.pgm\nresolution: 0.1\norigin: [1.0, 2.0, 0.0]\n";

/// -1, 0, 1 for free, unknown, occupied of the six pixels: the lower row first.
std::array<int, 6> signs(const OccupancyGrid& grid) {
    std::array<int, 6> all{};
    for (int i = 0; i < 6; ++i) {
        const std::int8_t odds = grid.log_odds({10 + i % 3, 20 + i / 3});
        all.at(static_cast<std::size_t>(i)) = odds == Patch::unknown ? 0 : odds > 0 ? 1 : -1;
    }
    return all;
}

TEST_F(MapServer, TrinaryHasThreeValues) {
    const OccupancyGrid grid = read(std::string(head) + "negate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    // 254 -> .004, 130 -> .49, 255 -> 0; 0 -> 1, 100 -> .608, 205 -> .19608
    EXPECT_EQ(signs(grid), (std::array<int, 6>{-1, 0, -1, 1, 0, 0}));
}

TEST_F(MapServer, NegateTurnsItAround) {
    const OccupancyGrid grid = read(std::string(head) + "negate: 1\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    // 254 -> .996, 130 -> .51, 255 -> 1; 0 -> 0, 100 -> .39, 205 -> .804
    EXPECT_EQ(signs(grid), (std::array<int, 6>{1, 0, 1, -1, 0, 1}));
}

TEST_F(MapServer, TheThresholdsAreHonoured) {
    const OccupancyGrid grid = read(std::string(head) + "negate: 0\noccupied_thresh: 0.5\nfree_thresh: 0.3\n");
    EXPECT_EQ(signs(grid), (std::array<int, 6>{-1, 0, -1, 1, 1, -1}));
}

TEST_F(MapServer, ScaleKeepsWhatLiesBetween) {
    const OccupancyGrid grid =
        read(std::string(head) + "mode: scale\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
    EXPECT_EQ(signs(grid), (std::array<int, 6>{-1, 1, -1, 1, 1, -1}));
    EXPECT_LT(grid.log_odds({11, 20}), grid.log_odds({11, 21}));  // .49 below .608
    EXPECT_LT(grid.log_odds({11, 21}), grid.log_odds({10, 21}));
}

TEST_F(MapServer, RawIsTheValueItself) {
    const OccupancyGrid grid = read(std::string(head) + "mode: raw\n");
    EXPECT_EQ(signs(grid), (std::array<int, 6>{0, 0, 0, -1, 1, 0}));  // 0 free, 100 occupied, more than 100 unknown
}

TEST_F(MapServer, TheOriginTurnsThePicture) {
    write_file(folder_ / "m.yaml", "image: m.pgm\nresolution: 0.1\norigin: [0, 0, " +
                                       std::to_string(std::numbers::pi / 2) + "]\nmode: trinary\n");
    const OccupancyGrid grid = read_map_server(folder_ / "m.yaml").grid;
    EXPECT_TRUE(grid.occupied({-2, 0}));  // the pixel (0, 1) has its centre at (0.05, 0.15), turned (-0.15, 0.05)
    EXPECT_LT(grid.log_odds({-1, 0}), 0);
    EXPECT_NE(grid.log_odds({-1, 0}), Patch::unknown);
    EXPECT_LT(grid.log_odds({-1, 2}), 0);
    EXPECT_EQ(grid.log_odds({0, 0}), Patch::unknown);
}

TEST_F(MapServer, WhatIsWrittenIsReadBack) {
    write_map_files(folder_ / "", "own", map_raster(test::small_map().grid));
    const OccupancyGrid read = read_any_map(folder_ / "own.yaml").grid;
    const OccupancyGrid& map = test::small_map().grid;
    const CellBox box = map.observed_box();
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            ASSERT_EQ(read.occupied({x, y}), map.occupied({x, y})) << x << ' ' << y;
            ASSERT_EQ(read.log_odds({x, y}) == Patch::unknown, map.log_odds({x, y}) == Patch::unknown);
        }
    }
}

TEST_F(MapServer, SaysWhatIsWrong) {
    EXPECT_THAT(refusal("resolution: 0.1\norigin: [0, 0, 0]\n"), HasSubstr("no 'image'"));
    EXPECT_THAT(refusal("image: m.pgm\norigin: [0, 0, 0]\n"), HasSubstr("no 'resolution'"));
    EXPECT_THAT(refusal("image: m.pgm\nresolution: fine\norigin: [0, 0, 0]\n"), HasSubstr("'resolution'"));
    EXPECT_THAT(refusal("image: m.pgm\nresolution: 0.1\norigin: [0]\n"), HasSubstr("[x, y, yaw]"));
    EXPECT_THAT(refusal(std::string(head) + "mode: colour\n"), HasSubstr("trinary, scale or raw"));
    EXPECT_THAT(refusal(std::string(head) + "free_thresh: 0.9\n"), HasSubstr("at most occupied_thresh"));
    EXPECT_THAT(refusal("image: other.pgm\nresolution: 0.1\norigin: [0, 0, 0]\n"), HasSubstr("other.pgm"));
    EXPECT_THAT(refusal("- a list\n"), HasSubstr("map_server"));
    EXPECT_THAT(refusal("image: [\n"), HasSubstr("no YAML"));
}

TEST_F(MapServer, PicturesThatAreNoneAreTold) {
    const auto refused = [&](const std::string& content) {
        write_file(folder_ / "bad.pgm", content);
        return ddtool::test::thrown_text([&] { read_pgm(folder_ / "bad.pgm", 1000); });
    };
    EXPECT_THAT(refused("P6\n1 1\n255\nxxx"), HasSubstr("P5 or P2"));
    EXPECT_THAT(refused("P5\n100 100\n255\n"), HasSubstr("its height is '100'"));
    EXPECT_THAT(refused("P5\n3 2\n255\nab"), HasSubstr("2 bytes of pixels; expected 6"));
    EXPECT_THAT(refused("P2\n2 1\n255\n1 x"), HasSubstr("a grey is 'x'"));
    EXPECT_THAT(refused("P2\n2 1\n0\n1 1"), HasSubstr("its lightest grey"));
    write_file(folder_ / "good.pgm", "P2\n2 1\n10\n5 10\n");
    EXPECT_EQ(read_pgm(folder_ / "good.pgm", 1000).grey, (std::vector<std::uint8_t>{127, 255}));
}

TEST_F(MapServer, AnythingElseIsNoMap) {
    write_file(folder_ / "some.txt", "text");
    EXPECT_THAT(ddtool::test::thrown_text([&] { read_any_map(folder_ / "some.txt"); }), HasSubstr("map.yaml"));
    EXPECT_THAT(ddtool::test::thrown_text([&] { read_any_map(folder_ / "none"); }), HasSubstr("no such file"));
    std::filesystem::create_directory(folder_ / "empty");
    EXPECT_THAT(ddtool::test::thrown_text([&] { read_any_map(folder_ / "empty"); }), HasSubstr("without a map"));
    write_map(folder_ / "empty/map.ddmap", "test", test::small_map());
    EXPECT_EQ(read_any_map(folder_ / "empty").nodes.size(), test::small_map().nodes.size());
}

}  // namespace
}  // namespace ddtool::maps

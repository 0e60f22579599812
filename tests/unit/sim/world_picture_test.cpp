#include "sim/world_picture.hpp"

#include <gtest/gtest.h>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool::sim {
namespace {

/// The big-endian number at a byte offset in the header of a PNG file.
std::uint32_t number_at(const std::string& file, std::size_t offset) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = value << 8U | static_cast<std::uint8_t>(file.at(offset + i));
    }
    return value;
}

TEST(WorldPicture, HasTheShapeOfTheWorldWithAMarginOfOneMetre) {
    const test::TemporaryFolder folder;
    World world;
    add_box(world, {5.0, 2.0, 0.0}, 38.0, 18.0);
    write_world_picture(folder / "world.png", world, {});
    const std::string png = read_file(folder / "world.png");
    EXPECT_EQ(number_at(png, 16), 1600U);
    EXPECT_EQ(number_at(png, 20), 800U);
}

TEST(WorldPicture, ShowsTheDrivenPath) {
    const test::TemporaryFolder folder;
    World world;
    add_box(world, {}, 10.0, 10.0);
    write_world_picture(folder / "world.png", world, {});
    write_world_picture(folder / "driven.png", world, {{0, {-4.0, 1.0, 0.0}}, {1, {4.0, 1.0, 0.0}}});
    EXPECT_NE(read_file(folder / "world.png"), read_file(folder / "driven.png"));
}

}  // namespace
}  // namespace ddtool::sim

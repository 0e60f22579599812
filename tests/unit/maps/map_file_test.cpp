#include "maps/map_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <string>

#include "ddtool/base/random.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/containers/mcap_writer.hpp"
#include "small_map.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::maps {
namespace {

using test::same_cells;
using test::small_map;

MapEdge loop_edge() {
    graph::RelativeEdge edge{.from = 0, .to = 2, .measured = {1.0, -0.5, 0.25}};
    edge.information << 4, 1, 0, 1, 5, 2, 0, 2, 6;
    edge.weight = 0.5;
    return {MapEdge::Kind::loop, edge};
}

TEST(MapFile, ReadsBackWhatWasWritten) {
    const ddtool::test::TemporaryFolder folder;
    SavedMap map = small_map();
    map.edges = {loop_edge()};
    write_map(folder / "map.ddmap", "this test", map);
    const SavedMap read = read_map(folder / "map.ddmap");
    EXPECT_EQ(read.program, "this test");
    EXPECT_EQ(read.settings, map.settings);
    ASSERT_EQ(read.nodes.size(), map.nodes.size());
    ASSERT_GT(read.nodes.size(), 5U);
    for (std::size_t node = 0; node < read.nodes.size(); ++node) {
        EXPECT_EQ(read.nodes[node].pose, map.nodes[node].pose);
        EXPECT_EQ(read.nodes[node].scan.stamp_ns, map.nodes[node].scan.stamp_ns);
        EXPECT_EQ(read.nodes[node].scan.odom_from_robot, map.nodes[node].scan.odom_from_robot);
        EXPECT_EQ(read.nodes[node].scan.points.unpacked().x_m, map.nodes[node].scan.points.unpacked().x_m);
    }
    ASSERT_EQ(read.drives.size(), 1U);
    EXPECT_EQ(read.drives[0].log, "small");
    ASSERT_TRUE(read.drives[0].odometry.has_value());
    EXPECT_EQ(read.drives[0].odometry->turn_per_rad.chords, map.drives[0].odometry->turn_per_rad.chords);
    ASSERT_EQ(read.edges.size(), 1U);
    EXPECT_EQ(read.edges[0].edge.information, map.edges[0].edge.information);
    EXPECT_EQ(read.edges[0].edge.weight, 0.5);
    EXPECT_TRUE(same_cells(map.grid, read.grid));
    EXPECT_TRUE(same_cells(read.grid, map.grid));
}

/// The field of nearest points is not stored but made anew of the occupied cells. It is then exact; in a map that grew,
/// a cell may keep a point that a hit has moved away from it a little.
TEST(MapFile, TheFieldIsThatOfTheMap) {
    const ddtool::test::TemporaryFolder folder;
    write_map(folder / "map.ddmap", "test", small_map());
    const OccupancyGrid read = read_map(folder / "map.ddmap", MapParts::grid).grid;
    const CellBox box = read.observed_box();
    const auto length = [](NearestPoint point) { return point.none() ? 1000.0 : std::hypot(point.x, point.y); };
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            const double kept = length(small_map().grid.nearest({x, y}));
            ASSERT_LE(length(read.nearest({x, y})), kept + 1e-9) << x << ' ' << y;
            ASSERT_GE(length(read.nearest({x, y})), kept - NearestPoint::units_per_cell) << x << ' ' << y;
        }
    }
}

TEST(MapFile, TheScansGiveTheMapAgain) {
    const OccupancyGrid again = drawn(small_map().nodes, small_map().grid.settings());
    const CellBox box = small_map().grid.observed_box();
    int occupied = 0;
    int different = 0;
    for (int y = box.y_min; y < box.y_max; ++y) {
        for (int x = box.x_min; x < box.x_max; ++x) {
            occupied += small_map().grid.occupied({x, y}) ? 1 : 0;
            different += small_map().grid.occupied({x, y}) != again.occupied({x, y}) ? 1 : 0;
        }
    }
    EXPECT_GT(occupied, 200);
    EXPECT_LT(different, occupied / 50);  // points are packed to a millimetre
}

TEST(MapFile, WithoutPosesAScanIsNoPartOfTheMap) {
    const ddtool::test::TemporaryFolder folder;
    MapFileWriter writer(folder / "map.ddmap", "test", Json::object(), {});
    writer.add(small_map().nodes[0].scan, 0);
    writer.add(small_map().nodes[1].scan, 0);
    writer.finish({{.log = "a", .odometry = {}}}, {small_map().nodes[0].pose}, {}, OccupancyGrid({}));
    EXPECT_EQ(read_map(folder / "map.ddmap").nodes.size(), 1U);
}

TEST(MapFile, WithoutEdgesTheOdometryTiesTheNodes) {
    const graph::PoseGraph graph = graph_of(small_map());
    EXPECT_EQ(graph.poses.size(), small_map().nodes.size());
    ASSERT_EQ(graph.matches.size(), small_map().nodes.size() - 1);
    EXPECT_GT(graph.matches[0].information(0, 0), 0.0);
}

TEST(MapFile, TellsWhatIsNoMap) {
    const ddtool::test::TemporaryFolder folder;
    write_file(folder / "text", "no map");
    EXPECT_THAT(ddtool::test::thrown_text([&] { read_map(folder / "text"); }), testing::HasSubstr("not an MCAP file"));
    EXPECT_FALSE(looks_like_map_file(folder / "text"));
    {
        Ros2Writer log(folder / "log");
        log.write("/pose", 1, RosPath{});
        log.close();
    }
    EXPECT_TRUE(looks_like_map_file(folder / "log"));
    EXPECT_THAT(ddtool::test::thrown_text([&] { read_map(folder / "log"); }),
                testing::AllOf(testing::HasSubstr("/pose"), testing::HasSubstr("expected a map file")));
    {
        Ros2Writer later(folder / "later");
        later.write("/map/header", 1, RosMapHeader{.format = map_format + 1, .program = {}, .settings = {}});
        later.close();
    }
    EXPECT_THAT(ddtool::test::thrown_text([&] { read_map(folder / "later"); }),
                testing::HasSubstr("expected format 1 to 1"));
}

void expect_refused(const std::filesystem::path& file, const std::string& content, std::size_t at) {
    std::ofstream(file, std::ios::binary) << content;
    const std::string text = ddtool::test::thrown_text([&] { read_map(file); });
    EXPECT_THAT(text, testing::HasSubstr(file.string())) << at;
    EXPECT_THAT(text, testing::Not(testing::HasSubstr("\n"))) << at;
}

/// A byte changed anywhere, and a file cut anywhere, is told in one line. The places are spread over the whole file.
TEST(MapFile, DamageIsToldWhereverItIs) {
    const ddtool::test::TemporaryFolder folder;
    write_map(folder / "map.ddmap", "test", small_map());
    const std::string whole = read_file(folder / "map.ddmap");
    constexpr std::size_t places = 240;
    for (std::size_t i = 0; i < places; ++i) {
        const std::size_t at = i < 60 ? i : i > places - 60 ? whole.size() - (places - i) : i * whole.size() / places;
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 0x10);
        expect_refused(folder / "broken", damaged, at);
        expect_refused(folder / "broken", whole.substr(0, at), at);
    }
}

/// Messages with changed bytes in a file whose checksums are right: every one is read or told, whatever it holds.
TEST(MapFile, WhatTheMessagesHoldIsNotTrusted) {
    const ddtool::test::TemporaryFolder folder;
    SavedMap map = small_map();
    map.nodes.resize(2);
    map.edges = {{MapEdge::Kind::match, {.from = 0, .to = 1, .measured = {}}}};
    map.grid = drawn(map.nodes, map.grid.settings());
    write_map(folder / "map.ddmap", "test", map);
    struct Kept {
        McapChannel channel;
        std::vector<std::byte> data;
    };
    std::vector<Kept> messages;
    McapReader reader(folder / "map.ddmap", {});
    while (const std::optional<McapMessage> message = reader.next()) {
        messages.push_back({*message->channel, {message->data.begin(), message->data.end()}});
    }
    std::size_t refused = 0;
    constexpr std::size_t trials = 300;
    for (std::size_t trial = 0; trial < trials; ++trial) {
        RandomStream random({5, trial});
        std::vector<Kept> changed = messages;
        const bool early = random.uniform() < 0.7;  // most messages are tiles
        std::vector<std::byte>& data = changed[early ? random.index(5) : random.index(changed.size())].data;
        for (std::uint64_t change = 0; change <= random.index(3); ++change) {
            data[4 + random.index(data.size() - 4)] = static_cast<std::byte>(random.index(256));
        }
        if (random.uniform() < 0.2) {
            data.resize(4 + random.index(data.size() - 4));
        }
        McapWriter writer(folder / "changed", {.profile = "ros2", .compression = Compression::none});
        std::map<std::string, std::uint16_t> channels;
        for (const Kept& message : changed) {
            const McapChannel& channel = message.channel;
            const auto [known, is_new] = channels.try_emplace(channel.topic, 0);
            if (is_new) {
                known->second = writer.add_channel(channel.topic, "cdr", channel.schema.name, "ros2msg", "");
            }
            writer.write(known->second, 1, message.data);
        }
        writer.close();
        const std::string text = ddtool::test::thrown_text([&] { graph_of(read_map(folder / "changed")); });
        refused += text.empty() ? 0 : 1;
        EXPECT_EQ(text.find('\n'), std::string::npos) << text;
    }
    EXPECT_GT(refused, trials / 10);
}

}  // namespace
}  // namespace ddtool::maps

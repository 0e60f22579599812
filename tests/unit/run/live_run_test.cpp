#include "run/live_run.hpp"

#include <gtest/gtest.h>

#include <map>

#include "logs/messages/ros2_schema.hpp"
#include "small_run.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

/// A sink that keeps the messages it is given.
class KeptMessages : public Ros2Sink {
public:
    std::map<std::string, std::vector<std::vector<std::byte>>> topics;

protected:
    void put(const std::string& topic, const char*, std::int64_t, std::span<const std::byte> data) override {
        topics[topic].emplace_back(data.begin(), data.end());
    }
};

TEST(LiveRun, TellsEveryScanAndShowsTheMapFromTheStartToTheEnd) {
    KeptMessages told;
    LiveRun live(told);
    test::SmallRun small;
    const FilterRun run = small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
        live.add(frame, update, small.filter());
        EXPECT_GE(told.topics["/map"].size(), 1U) << "with the first scan";
        return true;
    });
    const MapRaster map = map_raster(run.map);
    live.finish(map, run.trajectory);
    EXPECT_EQ(told.topics["/pose"].size(), run.trajectory.size());
    EXPECT_EQ(told.topics["/particlecloud"].size(), run.updates);
    EXPECT_EQ(told.topics["/degeneracy"].size(), run.updates);
    EXPECT_EQ(told.topics["/path"].size(), told.topics["/map"].size());
    const auto last = decode_cdr<RosOccupancyGrid>(told.topics["/map"].back());
    ASSERT_TRUE(last.has_value());
    EXPECT_EQ(last->data, map.cells);
}

TEST(LiveRun, ShowsAFixedMapOnceAndThePathAsItGrows) {
    KeptMessages told;
    LiveRun live(told, RunMessages::Reader::robot);
    MapRaster map;
    map.width = map.height = 1;
    map.cells = {MapRaster::occupied};
    live.show_fixed_map(1, map);
    test::SmallRun small;
    const FilterRun run = small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
        live.add(frame, update, small.filter());
        return true;
    });
    live.finish(map_raster(run.map), run.trajectory);
    ASSERT_EQ(told.topics["/map"].size(), 1U);
    EXPECT_EQ(decode_cdr<RosOccupancyGrid>(told.topics["/map"].front())->data, map.cells);
    EXPECT_GE(told.topics["/path"].size(), 2U);
}

TEST(LiveRun, GivesARobotNeitherItsScansNorItsTransforms) {
    KeptMessages told;
    LiveRun live(told, RunMessages::Reader::robot);
    test::SmallRun small;
    small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
        live.add(frame, update, small.filter());
        return true;
    });
    EXPECT_EQ(told.topics.count("/scan") + told.topics.count("/tf") + told.topics.count("/tf_static"), 0U);
    EXPECT_GT(told.topics["/map"].size() * told.topics["/pose"].size() * told.topics["/degeneracy"].size(), 0U);
}

/// The fields that a definition of a message type lists.
bool has_field(const char* type_name, const std::string& field) {
    return (" " + ros2_schema(type_name)).find(" " + field + "\n") != std::string::npos;
}

TEST(FoxgloveLayout, ShowsTopicsAndFieldsThatThereAre) {
    KeptMessages told;
    LiveRun live(told);
    test::SmallRun small;
    small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
        live.add(frame, update, small.filter());
        return true;
    });
    const Json layout = parse_json(read_file(FOXGLOVE_LAYOUT), FOXGLOVE_LAYOUT, /*comments=*/false);
    const Json& panels = layout.at("configById");
    for (const auto& [topic, look] : panels.at("3D!ddtool").at("topics").items()) {
        EXPECT_TRUE(told.topics.contains(topic)) << topic;
        EXPECT_TRUE(look.at("visible")) << topic;
    }
    for (const char* panel : {"Plot!degree", "Plot!variance"}) {
        for (const Json& path : panels.at(panel).at("paths")) {
            const auto value = path.at("value").get<std::string>();
            const std::string topic = "/degeneracy.";
            ASSERT_TRUE(value.starts_with(topic)) << value;
            EXPECT_TRUE(has_field(RosDegeneracy::type_name, value.substr(topic.size()))) << value;
        }
    }
    for (const auto& [panel, config] : panels.items()) {
        EXPECT_NE(layout.at("layout").dump().find("\"" + panel + "\""), std::string::npos) << panel;
    }
}

TEST(LiveRun, SaysNothingOfARunThatHadNoScan) {
    KeptMessages told;
    LiveRun(told).finish(MapRaster{}, {});
    EXPECT_TRUE(told.topics.empty());
}

}  // namespace
}  // namespace ddtool

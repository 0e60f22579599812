#include "run/live_run.hpp"

#include <gtest/gtest.h>

#include <map>

#include "small_run.hpp"

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

TEST(LiveRun, SaysNothingOfARunThatHadNoScan) {
    KeptMessages told;
    LiveRun(told).finish(MapRaster{}, {});
    EXPECT_TRUE(told.topics.empty());
}

}  // namespace
}  // namespace ddtool

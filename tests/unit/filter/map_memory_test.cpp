#include <gmock/gmock.h>

#include <deque>
#include <limits>

#include "ddtool/filter/filter_run.hpp"
#include "room_run.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

std::size_t live_bytes() { return MapBytes::live.load(); }

class GivenFrames : public SensorStream {
public:
    explicit GivenFrames(const std::vector<SensorFrame>& frames) : frames_(frames.begin(), frames.end()) {}
    std::optional<SensorFrame> next() override {
        if (frames_.empty()) {
            return std::nullopt;
        }
        const SensorFrame frame = frames_.front();
        frames_.pop_front();
        return frame;
    }
    [[nodiscard]] double fraction_read() const override { return 0.0; }

private:
    std::deque<SensorFrame> frames_;
};

FilterRun run_with(std::uint64_t most_memory_mib, std::size_t particles) {
    RbpfSettings settings = few_particles(particles);
    settings.grid.cell_size_m = 0.01;
    settings.grid.most_memory_mib = most_memory_mib;
    ThreadPool threads(2);
    Rbpf filter(settings, threads);
    GivenFrames frames(room_drive());
    return run_filter(frames, filter, [](const auto&...) { return true; });
}

TEST(MapBytes, CountPatchesOnceHoweverManyMapsShareThem) {
    const std::size_t before = live_bytes();
    {
        OccupancyGrid grid{OccupancySettings{}};
        grid.reserve({0, 0, 100, 100});
        const std::size_t table = live_bytes() - before;
        EXPECT_GT(table, 0U);
        grid.add_free(0, 0, Patch::size_cells);
        EXPECT_EQ(live_bytes() - before, table + sizeof(Patch));
        OccupancyGrid copy = grid;
        EXPECT_EQ(live_bytes() - before, 2 * table + sizeof(Patch));
        copy.add_free(0, 0, Patch::size_cells);
        EXPECT_EQ(live_bytes() - before, 2 * table + 2 * sizeof(Patch));
    }
    EXPECT_EQ(live_bytes(), before);
}

TEST(MapMemory, ALimitEndsTheRunWithWhatItHas) {
    const FilterRun whole = run_with(0, 20);
    EXPECT_EQ(whole.ended_early, "");
    const FilterRun cut = run_with(40, 20);
    EXPECT_THAT(cut.ended_early, testing::HasSubstr("do not fit into 40 MiB"));
    EXPECT_GT(cut.updates, 0U);
    ASSERT_GT(cut.trajectory.size(), 0U);
    ASSERT_LT(cut.trajectory.size(), whole.trajectory.size());
    EXPECT_EQ(cut.trajectory.size(), cut.ground_truth.size());
    EXPECT_EQ(cut.trajectory.front().pose, whole.trajectory.front().pose);
    EXPECT_FALSE(cut.map.observed_box().empty());
}

TEST(MapMemory, IsNeverTakenBeyondTheLimit) {
    constexpr std::uint64_t limit_mib = 40;
    std::size_t most = 0;
    RbpfSettings settings = few_particles(20);
    settings.grid.cell_size_m = 0.01;
    settings.grid.most_memory_mib = limit_mib;
    ThreadPool threads(1);
    Rbpf filter(settings, threads);
    GivenFrames frames(room_drive());
    (void)run_filter(frames, filter, [&](const auto&...) {
        most = std::max(most, live_bytes());
        return true;
    });
    EXPECT_GT(most, limit_mib << 19U) << "the limit is reached at all";
    EXPECT_LE(live_bytes(), limit_mib << 20U);
    EXPECT_LE(most, limit_mib << 20U);
}

TEST(MapMemory, ALimitThatTheFirstScanExceedsIsAnError) {
    EXPECT_THAT(test::thrown_text<MapTooLarge>([] { run_with(1, 20); }), testing::HasSubstr("do not fit into 1 MiB"));
}

TEST(MapMemory, IsAlsoKeptForDrawingTheMap) {
    constexpr int far_cells = 40000;  // 2 km: 40,000 x 40,000 cells, two bytes each, make 3.2 GB
    OccupancySettings settings;
    settings.most_memory_mib = 1024;
    OccupancyGrid grid{settings};
    grid.reserve({0, 0, 1, 1});
    EXPECT_THROW(grid.reserve({far_cells, far_cells, far_cells + 1, far_cells + 1}), MapTooLarge);
    settings.most_memory_mib = 4096;
    OccupancyGrid roomy{settings};
    roomy.reserve({0, 0, 1, 1});
    EXPECT_NO_THROW(roomy.reserve({far_cells, far_cells, far_cells + 1, far_cells + 1}));
}

TEST(MapMemory, AJumpToNowhereEndsTheRunWithWhatItHas) {
    std::vector<SensorFrame> frames = room_drive();
    const std::size_t good = frames.size() / 2;
    for (std::size_t i = good; i < frames.size(); ++i) {
        frames[i].odom_from_robot = Pose2{1e8, 0.0, 0.0} * frames[i].odom_from_robot;
    }
    ThreadPool threads(1);
    Rbpf filter(few_particles(), threads);
    GivenFrames stream(frames);
    const FilterRun run = run_filter(stream, filter, [](const auto&...) { return true; });
    EXPECT_THAT(run.ended_early, testing::HasSubstr("the poses jump"));
    EXPECT_EQ(run.trajectory.size(), good);
}

}  // namespace
}  // namespace ddtool

#include <benchmark/benchmark.h>

#include "ddtool/base/thread_pool.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "ddtool/filter/scan_insertion.hpp"
#include "sim/simulated_stream.hpp"
#include "sim/world_catalogue.hpp"

namespace ddtool {
namespace {

/// The first scan of a room, and a map that was made from it.
struct MappedScan {
    MappedScan() {
        sim::SimulatedStream stream(sim::load_world("s1"), {});
        frame = *stream.next();
        points = scan_points(frame, {});
        match_points = MatchPoints(points, grid.cell_size_m());
        ScanInserter().insert(grid, points, frame.odom_from_robot);
    }

    SensorFrame frame;
    OccupancyGrid grid{OccupancySettings{}};
    ScanPoints points;
    MatchPoints match_points;
};

void prepare_scan(benchmark::State& state) {
    const MappedScan scan;
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(scan_points(scan.frame, {}));
    }
}
BENCHMARK(prepare_scan)->Unit(benchmark::kMicrosecond);

void match_scan(benchmark::State& state) {
    const MappedScan scan;
    ScanMatcher matcher({}, scan.grid.cell_size_m());
    const Pose2 start = scan.frame.odom_from_robot * Pose2{0.05, -0.03, 0.03};
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(matcher.match(scan.grid, scan.match_points, start, {}));
    }
    state.counters["points"] = static_cast<double>(scan.points.size());
}
BENCHMARK(match_scan)->Unit(benchmark::kMicrosecond);

void evaluate(benchmark::State& state) {
    const MappedScan scan;
    ScanMatcher matcher({}, scan.grid.cell_size_m());
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(matcher.evaluate(scan.grid, scan.match_points, scan.frame.odom_from_robot));
    }
}
BENCHMARK(evaluate)->Unit(benchmark::kMicrosecond);

void insert_scan(benchmark::State& state) {
    MappedScan scan;
    ScanInserter inserter;
    for ([[maybe_unused]] auto _ : state) {
        inserter.insert(scan.grid, scan.points, scan.frame.odom_from_robot);
    }
}
BENCHMARK(insert_scan)->Unit(benchmark::kMicrosecond);

void copy_grid(benchmark::State& state) {
    const MappedScan scan;
    for ([[maybe_unused]] auto _ : state) {
        OccupancyGrid copy = scan.grid;
        benchmark::DoNotOptimize(copy);
    }
}
BENCHMARK(copy_grid)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace ddtool

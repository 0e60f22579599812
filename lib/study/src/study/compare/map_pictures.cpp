#include <algorithm>
#include <array>

#include "report/map_raster.hpp"
#include "study/compare/run_pictures.hpp"
#include "study/compare/trajectory_map.hpp"

namespace ddtool::compare {
namespace {

plot::Range x_of(const MapRaster& map) { return {map.origin_m.x_m, map.origin_m.x_m + map.width_m()}; }
plot::Range y_of(const MapRaster& map) { return {map.origin_m.y_m, map.origin_m.y_m + map.height_m()}; }

struct NamedMap {
    std::string title;
    MapRaster raster;
};

/// One pass over the data for all of them; the truth's first.
std::vector<NamedMap> maps_of(const ShownRun& run) {
    std::vector<TrajectoryMap> maps;
    std::vector<NamedMap> named;
    if (!run.truth.empty()) {
        maps.emplace_back(run.truth);
        named.push_back({"truth", {}});
    }
    for (const ShownEstimate& estimate : run.estimates) {
        maps.emplace_back(estimate.trajectory);
        named.push_back({estimate.title(), {}});
    }
    const std::unique_ptr<SensorStream> stream = run.data->open([](const LogProblem&) {});
    while (const std::optional<SensorFrame> frame = stream->next()) {
        std::for_each(maps.begin(), maps.end(), [&](TrajectoryMap& map) { map.add(*frame); });
    }
    for (std::size_t index = 0; index < maps.size(); ++index) {
        named[index].raster = map_raster(maps[index].grid());
    }
    return named;
}

}  // namespace

void draw_maps(const std::filesystem::path& file, const ShownRun& run) {
    const std::vector<NamedMap> maps = maps_of(run);
    Extent extent;
    for (const NamedMap& map : maps) {
        extent.x.include(x_of(map.raster).low);
        extent.x.include(x_of(map.raster).high);
        extent.y.include(y_of(map.raster).low);
        extent.y.include(y_of(map.raster).high);
    }
    write_side_by_side(file, extent, maps.size(), [&](plot::Axes& axes, std::size_t panel) {
        const MapRaster& map = maps[panel].raster;
        const std::vector<std::uint8_t> pixels = map_pixels(map);
        const std::array<std::uint8_t, 1> unknown_pixel{map_grey(MapRaster::unknown)};
        axes.title(maps[panel].title);
        axes.picture({.width_px = 1, .height_px = 1, .channels = 1, .pixels = unknown_pixel}, extent.x, extent.y);
        axes.picture({.width_px = map.width, .height_px = map.height, .channels = 1, .pixels = pixels}, x_of(map),
                     y_of(map));
    });
}

}  // namespace ddtool::compare

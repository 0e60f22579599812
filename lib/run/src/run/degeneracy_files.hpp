#pragma once

#include <filesystem>
#include <vector>

#include "ddtool/robot/trajectory.hpp"
#include "report/map_raster.hpp"
#include "run/run_course.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {

/// Writes degeneracy.csv, one row per update (docs/formats/results.md). Every member throws Error that names the file
/// if it cannot be written.
class DegeneracyCsv {
public:
    explicit DegeneracyCsv(const std::filesystem::path& file);
    void add(const UpdateSummary& update);
    /// Completes the file. If this is never called, no file is left behind.
    void close() { file_.close(); }

private:
    AtomicStream file_;
};

/// Draws the map with the path coloured by the degree, and below it the degree and the swarm's spread over time. `path`
/// has a pose for every scan. Throws Error that names the file if it cannot be written.
void write_degeneracy_picture(const std::filesystem::path& file, const std::vector<UpdateSummary>& updates,
                              const MapRaster& map, const Trajectory& path);

}  // namespace ddtool

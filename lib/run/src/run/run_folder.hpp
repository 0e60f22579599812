#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/filter/filter_run.hpp"
#include "ddtool/system/settings.hpp"
#include "maps/map_file.hpp"
#include "report/map_raster.hpp"
#include "report/page.hpp"
#include "run/back_end_results.hpp"
#include "run/degeneracy_files.hpp"
#include "run/result_log.hpp"
#include "run/run_course.hpp"
#include "run/snapshot_file.hpp"
#include "scores/tum_file.hpp"

namespace ddtool {

/// The files of one run of the filter (docs/formats/results.md). Each file appears only once it is complete. A file of
/// an earlier run that this run does not replace is removed at the end. Every member that writes throws Error that
/// names the file.
class RunFolder {
public:
    /// Creates the folder. snapshots.mcap is written only if `with_snapshots` is true.
    RunFolder(std::filesystem::path folder, bool with_snapshots);

    /// Call this after the filter has processed the frame. `update` is empty where the frame caused no update.
    void add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter);
    /// Begins map.ddmap, which grows with the run. `program` is what writes it, with its version.
    void begin_map_file(const std::string& program, const Json& settings, const OccupancySettings& cells);
    /// Adds the next scan that entered the filter's map.
    void add(const graph::Node& node);
    /// Completes map.ddmap after finish(). `graph` is null if there was none.
    void finish_map_file(const std::string& log, const FilterRun& run, const graph::PoseGraph* graph);
    /// Writes map.ddmap as a whole, after finish(), where begin_map_file() was not called.
    void write_map_file(const std::string& program, const maps::SavedMap& map);
    /// Writes the trajectories, the map and its picture, and completes the MCAP files.
    void finish(const FilterRun& run, const MapRaster& map);
    /// Writes the graph, its nodes and the path before the back end; without results removes those of an earlier run.
    void write_back_end(const BackEndResults* results);
    void write_json(const std::string& name, const Json& content);
    /// Writes report.html as report::write_page() does and returns whether it could be written.
    bool write_page(const std::function<report::Page()>& make);
    /// What the filter has done so far, in as much detail as pictures need.
    [[nodiscard]] const RunCourse& course() const { return course_; }

    /// The names of the files written so far.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }
    /// The wall time spent in this class, in seconds.
    [[nodiscard]] double write_s() const { return write_s_; }

private:
    std::filesystem::path place(const std::string& name);
    void write_trajectory(const std::string& name, const Trajectory& trajectory);
    void complete_streams();

    std::filesystem::path folder_;
    std::vector<std::string> files_;
    ResultLog result_;
    std::optional<SnapshotWriter> snapshots_;
    std::optional<maps::MapFileWriter> map_file_;
    std::vector<std::size_t> node_scans_;  ///< the scans of the run in map.ddmap, by their number in the run
    DegeneracyCsv degeneracy_;
    TumStream online_;
    RunCourse course_;
    double write_s_ = 0.0;
};

}  // namespace ddtool

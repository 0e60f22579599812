#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/settings.hpp"
#include "results/map_raster.hpp"
#include "results/result_log.hpp"
#include "slam/filter_run.hpp"

namespace ddtool {

/// The files of one run of the filter (docs/formats/results.md). Each appears when it is whole; a file that this run
/// does not write, but an earlier one did, is removed at the end. Every call throws Error naming the file.
class RunFolder {
public:
    /// Creates the folder.
    explicit RunFolder(std::filesystem::path folder);

    /// After the filter has moved.
    void add(const SensorFrame& frame, const Rbpf& filter) { result_.add(frame, filter); }
    /// Writes the trajectories, the map and its picture, and completes result.mcap.
    void finish(const FilterRun& run, const MapRaster& map);
    void write_json(const std::string& name, const Json& content);

    /// Names of the files written.
    [[nodiscard]] const std::vector<std::string>& files() const { return files_; }

private:
    std::filesystem::path place(const std::string& name);
    void write_trajectory(const std::string& name, const Trajectory& trajectory);

    std::filesystem::path folder_;
    std::vector<std::string> files_;
    ResultLog result_;
};

}  // namespace ddtool

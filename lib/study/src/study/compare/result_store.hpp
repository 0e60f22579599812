#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "ddtool/robot/trajectory.hpp"
#include "study/compare/experiment.hpp"

namespace ddtool::compare {

/// What came out of a cell.
struct CellResult {
    std::string failure;           ///< why there is no score; empty: there is one
    Json score = Json::object();   ///< score_json() of the trajectory
    std::string program;           ///< the build of ddtool that computed it
    std::size_t scans = 0;         ///< frames of the log
    std::size_t log_problems = 0;  ///< things in the log that were skipped
    double duration_s = 0.0;       ///< wall time, reading or simulating included
};

/// The results of finished cells in a folder, by the cells' ids: ID.json and ID.tum under cells/, true trajectories
/// under truth/. Every file is written whole or not at all, the JSON last, so that a killed run leaves only finished
/// cells. Safe to use from many threads.
class ResultStore {
public:
    /// Makes the folders; throws Error.
    explicit ResultStore(const std::filesystem::path& folder);

    /// None for a cell that has not been finished. Throws Error naming the file for one that is not such a file.
    [[nodiscard]] std::optional<CellResult> load(const Cell& cell) const;
    void save(const Cell& cell, const CellResult& result, const Trajectory& estimate);
    /// The true trajectory of a cell's data; kept once for all methods.
    void save_truth(const Cell& cell, const Trajectory& truth);

    [[nodiscard]] Trajectory estimate(const Cell& cell) const;
    [[nodiscard]] Trajectory truth(const Cell& cell) const;

private:
    [[nodiscard]] std::filesystem::path cell_file(const Cell& cell, const std::string& extension) const;
    [[nodiscard]] std::filesystem::path truth_file(const Cell& cell) const;

    std::filesystem::path folder_;
    std::mutex truth_mutex_;
};

}  // namespace ddtool::compare

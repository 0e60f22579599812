#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "ddtool/robot/trajectory.hpp"
#include "scores/trajectory_score.hpp"
#include "study/compare/experiment.hpp"

namespace ddtool::compare {

/// The result of a cell.
struct CellResult {
    std::string failure;           ///< why there is no score; empty: there is one
    ScoreFigures score;            ///< of the trajectory
    std::string program;           ///< the build of ddtool that computed it
    std::size_t scans = 0;         ///< frames of the log
    std::size_t log_problems = 0;  ///< problems in the log whose places were skipped
    double duration_s = 0.0;       ///< wall time, including reading or simulating
};

/// The results of finished cells in a folder, by the cells' ids: ID.json and ID.tum under cells/, true trajectories
/// under truth/. See jobs::Store. Safe to use from many threads.
class ResultStore {
public:
    /// Creates the folders. Throws Error if that fails.
    explicit ResultStore(const std::filesystem::path& folder);

    /// Returns nullopt for a cell that has not been finished and, after a warning, for one with a damaged file.
    [[nodiscard]] std::optional<CellResult> load(const Cell& cell) const;
    void save(const Cell& cell, const CellResult& result, const Trajectory& estimate);
    /// Stores the true trajectory of a cell's data, which is the same for all contestants.
    void save_truth(const Cell& cell, const Trajectory& truth);

    [[nodiscard]] Trajectory estimate(const Cell& cell) const;
    [[nodiscard]] Trajectory truth(const Cell& cell) const;

private:
    [[nodiscard]] std::filesystem::path truth_file(const Cell& cell) const;

    jobs::Store cells_;
    std::filesystem::path truth_folder_;
    std::mutex truth_mutex_;  ///< cells of the same data write the same file
};

}  // namespace ddtool::compare

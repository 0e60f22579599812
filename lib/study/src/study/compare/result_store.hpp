#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "ddtool/robot/trajectory.hpp"
#include "scores/trajectory_score.hpp"
#include "study/compare/experiment.hpp"

namespace ddtool::compare {

/// What came out of a cell.
struct CellResult {
    std::string failure;           ///< why there is no score; empty: there is one
    ScoreFigures score;            ///< of the trajectory
    std::string program;           ///< the build of ddtool that computed it
    std::size_t scans = 0;         ///< frames of the log
    std::size_t log_problems = 0;  ///< things in the log that were skipped
    double duration_s = 0.0;       ///< wall time, reading or simulating included
};

/// The results of finished cells in a folder, by the cells' ids: ID.json and ID.tum under cells/, true trajectories
/// under truth/. See jobs::Store. Safe to use from many threads.
class ResultStore {
public:
    /// Makes the folders; throws Error.
    explicit ResultStore(const std::filesystem::path& folder);

    /// Nullopt for a cell that has not been finished, or of which a file is damaged, which a warning tells.
    [[nodiscard]] std::optional<CellResult> load(const Cell& cell) const;
    void save(const Cell& cell, const CellResult& result, const Trajectory& estimate);
    /// The true trajectory of a cell's data, the same for all contestants.
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

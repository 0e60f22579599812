#include "study/compare/result_store.hpp"

#include "ddtool/system/json_struct.hpp"
#include "scores/tum_file.hpp"
#include "system/folder.hpp"

namespace ddtool::compare {

DDTOOL_JSON_STRUCT(CellResult, score, program, scans, log_problems, duration_s)

ResultStore::ResultStore(const std::filesystem::path& folder)
    : cells_(made_folder(folder / "cells"), {.value_key = "result"}), truth_folder_(made_folder(folder / "truth")) {}

std::optional<CellResult> ResultStore::load(const Cell& cell) const {
    return cells_.find(cell.key, [&](const Json& json) {
        const auto result = json.get<CellResult>();
        // reads the trajectory, so that a damaged file is noticed now, when the cell can still be run again
        (void)estimate(cell);
        if (result.score.ate_m) {
            (void)truth(cell);
        }
        return result;
    });
}

void ResultStore::save(const Cell& cell, const CellResult& result, const Trajectory& estimate) {
    write_tum(cells_.file(cell.key, ".tum"), estimate);
    cells_.save(cell.key, result);
}

void ResultStore::save_truth(const Cell& cell, const Trajectory& truth) {
    const std::scoped_lock lock(truth_mutex_);
    write_tum(truth_file(cell), truth);
}

Trajectory ResultStore::estimate(const Cell& cell) const { return read_tum(cells_.file(cell.key, ".tum")); }

Trajectory ResultStore::truth(const Cell& cell) const { return read_tum(truth_file(cell)); }

std::filesystem::path ResultStore::truth_file(const Cell& cell) const {
    return truth_folder_ / (cell.data_id + ".tum");
}

}  // namespace ddtool::compare

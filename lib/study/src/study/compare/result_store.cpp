#include "study/compare/result_store.hpp"

#include "ddtool/base/error.hpp"
#include "ddtool/system/json_struct.hpp"
#include "scores/tum_file.hpp"
#include "system/atomic_file.hpp"
#include "system/folder.hpp"

namespace ddtool::compare {

DDTOOL_JSON_STRUCT(CellResult, score, program, scans, log_problems, duration_s)

ResultStore::ResultStore(const std::filesystem::path& folder) : folder_(folder) {
    made_folder(folder_ / "cells");
    made_folder(folder_ / "truth");
}

std::optional<CellResult> ResultStore::load(const Cell& cell) const {
    const std::filesystem::path file = cell_file(cell, ".json");
    if (!std::filesystem::exists(file)) {
        return std::nullopt;
    }
    const Json json = Json::parse(read_file(file), nullptr, false);
    if (!json.is_object() || json.value("configuration", Json()) != cell.configuration) {
        throw Error(file.string() + ": expected the result of the configuration that its name stands for; remove it");
    }
    return json.at("result").get<CellResult>();
}

void ResultStore::save(const Cell& cell, const CellResult& result, const Trajectory& estimate) {
    write_tum(cell_file(cell, ".tum"), estimate);
    write_file(cell_file(cell, ".json"),
               Json{{"configuration", cell.configuration}, {"result", result}}.dump(2) + "\n");
}

void ResultStore::save_truth(const Cell& cell, const Trajectory& truth) {
    const std::scoped_lock lock(truth_mutex_);
    if (!std::filesystem::exists(truth_file(cell))) {
        write_tum(truth_file(cell), truth);
    }
}

Trajectory ResultStore::estimate(const Cell& cell) const { return read_tum(cell_file(cell, ".tum")); }

Trajectory ResultStore::truth(const Cell& cell) const { return read_tum(truth_file(cell)); }

std::filesystem::path ResultStore::cell_file(const Cell& cell, const std::string& extension) const {
    return folder_ / "cells" / (cell.id + extension);
}

std::filesystem::path ResultStore::truth_file(const Cell& cell) const {
    return folder_ / "truth" / (cell.data_id + ".tum");
}

}  // namespace ddtool::compare

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "jobs/store.hpp"
#include "scores/absolute_error.hpp"
#include "study/compare/contestant.hpp"
#include "study/compare/data_source.hpp"
#include "system/setting_rows.hpp"

namespace ddtool::compare {

/// What a publication prints for a method in a world. Its methods need not be among the contestants.
struct PrintedErrors {
    std::string world;
    std::string method;
    std::array<double, 3> errors_m{};  ///< ATE, Error_x, Error_y; NaN where it prints a dash
};

/// Contestants x worlds x seeds.
struct Experiment {
    std::vector<WorldEntry> worlds;
    std::vector<Contestant> contestants;
    std::vector<std::uint64_t> seeds;
    std::size_t baseline = 0;  ///< the contestant that the others are tested against
    AteOptions score;
    std::vector<PrintedErrors> paper;  ///< for the experiment's worlds
};

/// The description of every setting of an experiment, in the order of the settings in JSON.
std::vector<Setting> experiment_setting_list();

/// Every setting of an experiment with its default: the keys a configuration may have.
Json default_experiment_json();

/// detectors: the detectors that contestants may name. Optional contestants without any file are left out, of which an
/// info tells. Throws UsageError that names the key if the settings make no
/// sense: if there is nothing to compare, a name occurs twice, or a name is unknown.
Experiment experiment_from_json(const Json& settings, const DetectorTable& detectors = {});

/// One contestant on one world with one seed.
struct Cell {
    std::size_t world = 0;
    std::size_t contestant = 0;
    std::size_t seed = 0;  ///< position in the experiment's seeds
    std::shared_ptr<const DataSource> data;
    jobs::Key key;        ///< of everything that decides the result
    std::string data_id;  ///< fingerprint of data->identity: the same for all contestants
};

/// All cells, ordered by seed first, so that an experiment that was stopped early has complete seeds.
std::vector<Cell> cells_of(const Experiment& experiment);

/// The text for messages: "s2 / gmapping / seed 3".
std::string title_of(const Experiment& experiment, const Cell& cell);

}  // namespace ddtool::compare

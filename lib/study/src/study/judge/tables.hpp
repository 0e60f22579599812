#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// One row for each detector: what it looks at, what it was trained and tested on, and the counts of its decisions. The
/// positive class is degenerate.
Table detector_table(std::span<const Evaluation> evaluations, const Task& task);

/// Mean and standard deviation over models that differ in nothing but their seeds. If two models of a family have the
/// same seed, they must differ in something else, so the whole family is left out.
Table seed_table(std::span<const Evaluation> evaluations, const Task& task);

/// Calibration errors and temperatures of the detectors that give degrees.
Table calibration_table(std::span<const Evaluation> evaluations, const Task& task);

/// How well scores agree with the physics, by kind of source.
Table physics_table(std::span<const Evaluation> evaluations);

/// A detector's figures by scene, lidar, odometry, update distance and number of particles.
Table group_table(const dataset::Dataset& data, std::span<const Evaluation> evaluations);

struct NamedTable {
    std::string name;
    Table table;
};

/// All tables above that have rows, in that order. The group table covers only the evaluations of detailed().
std::vector<NamedTable> evaluation_tables(const dataset::Dataset& data, std::span<const Evaluation> evaluations,
                                          const Task& task);

/// All of this as JSON, for other programs.
Json evaluation_json(const dataset::Dataset& data, std::span<const Evaluation> evaluations, const Task& task);

}  // namespace ddtool::judge

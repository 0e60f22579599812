#pragma once

#include <span>
#include <string>
#include <vector>

#include "report/table.hpp"
#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// A row a detector: what it looks at, what it was trained on and tested on, its decisions counted. The positive class
/// is degenerate.
Table detector_table(std::span<const Evaluation> evaluations, const Task& task);

/// Mean and standard deviation over models that differ in nothing but their seeds. Two of one seed differ in something
/// else, so they and their likes are left out.
Table seed_table(std::span<const Evaluation> evaluations, const Task& task);

/// Detectors that give degrees: calibration errors and temperatures.
Table calibration_table(std::span<const Evaluation> evaluations, const Task& task);

/// Scores and physics, by kind of source.
Table physics_table(std::span<const Evaluation> evaluations);

/// A detector's figures by scene, lidar, odometry, update distance and number of particles.
Table group_table(const dataset::Dataset& data, std::span<const Evaluation> evaluations);

struct NamedTable {
    std::string name;
    Table table;
};

/// All of the above that have rows, in that order; groups for those of detailed() alone.
std::vector<NamedTable> evaluation_tables(const dataset::Dataset& data, std::span<const Evaluation> evaluations,
                                          const Task& task);

/// Everything for machines.
Json evaluation_json(const dataset::Dataset& data, std::span<const Evaluation> evaluations, const Task& task);

}  // namespace ddtool::judge

#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ddtool/robot/trajectory.hpp"
#include "ddtool/system/settings.hpp"
#include "graph/back_end.hpp"
#include "report/table.hpp"

namespace ddtool {

/// The back end's result, for the files and the report of a run.
struct BackEndResults {
    graph::Smoothed smoothed;
    Trajectory by_filter;     ///< a pose for every scan, before the back end
    Trajectory ground_truth;  ///< empty if it is unknown
    double wall_s = 0.0;
    double cpu_s = 0.0;
};

/// How the true errors compare with the covariances: the mean over the nodes of the squared error in units of its
/// covariance (normalised estimation error squared, NEES), with the first node's pose taken as true, since the graph
/// holds it. A covariance that is right gives 2 for the position and 1 for the heading.
struct NormalisedErrors {
    std::size_t nodes = 0;
    double position = 0.0;
    double heading = 0.0;
};
std::optional<NormalisedErrors> normalised_errors(const graph::Smoothed& smoothed, const Trajectory& ground_truth);

/// The form of run.json (docs/formats/results.md).
Json back_end_json(const BackEndResults& results);

/// One row for each reason why pairs of places were taken as loops or refused, with their number.
Table loop_table(const std::vector<graph::Loop>& loops);

/// Writes the nodes with their covariances. Throws OutputError naming the file.
void write_graph_nodes(const std::filesystem::path& file, const graph::Smoothed& smoothed);

}  // namespace ddtool

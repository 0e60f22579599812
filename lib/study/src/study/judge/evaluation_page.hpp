#pragma once

#include <filesystem>
#include <span>

#include "report/page.hpp"
#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// Adds the results of the detectors to a report (docs/reports.md): the tables and, for evaluations that have samples,
/// the pictures that draw_evaluations() made in the folder. Throws Error if a picture is missing.
void add_evaluations(report::Page& page, const std::filesystem::path& folder, const dataset::Dataset& data,
                     std::span<const Evaluation> evaluations, const Task& task);

}  // namespace ddtool::judge

#pragma once

#include <filesystem>
#include <span>

#include "report/page.hpp"
#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// Adds what is known of the detectors to a report (docs/reports.md): the tables, and, where there are samples, the
/// pictures that draw_evaluations() made in the folder. Throws Error for a picture that is missing.
void add_evaluations(report::Page& page, const std::filesystem::path& folder, const dataset::Dataset& data,
                     std::span<const Evaluation> evaluations, const Task& task);

}  // namespace ddtool::judge

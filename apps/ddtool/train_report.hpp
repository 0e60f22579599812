#pragma once

#include "report/table.hpp"
#include "train/engine.hpp"

namespace ddtool {

/// The best epoch's figures.
Table result_table(const train::TrainResult& result);

/// What --json prints: settings, figures of the best epoch, what was written where.
Json result_json(const train::TrainRequest& request, const train::TrainResult& result);

/// Writes report.html (docs/reports.md) into the folder of a training that came to its end: curves, and how the best
/// network decides on the part validation, with pictures of it in the folder pictures. Returns whether it could be
/// written.
bool write_train_page(const train::Engine& engine, const train::TrainRequest& request,
                      const train::TrainResult& result);

}  // namespace ddtool

#pragma once

#include "report/table.hpp"
#include "train/engine.hpp"

namespace ddtool {

/// A table with the figures of the best epoch.
Table result_table(const train::TrainResult& result);

/// The output of --json: the settings, the figures of the best epoch, and the files that were written.
Json result_json(const train::TrainRequest& request, const train::TrainResult& result);

/// Writes report.html (docs/reports.md) into the folder of a completed training: its curves, and how the best network
/// decides on the part `validation`. The pictures go into the folder `pictures`. Returns whether the report could be
/// written.
bool write_train_page(const train::Engine& engine, const train::TrainRequest& request,
                      const train::TrainResult& result);

}  // namespace ddtool

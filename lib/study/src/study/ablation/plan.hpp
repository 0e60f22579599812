#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "system/setting_rows.hpp"
#include "train/train_settings.hpp"

namespace ddtool::ablation {

inline constexpr double not_printed = std::numeric_limits<double>::quiet_NaN();

/// The figures that the paper prints for a row.
struct Printed {
    double accuracy = not_printed;
    double f1 = not_printed;
};

/// A row of the table: a training.
struct Row {
    std::string name;
    train::TrainSettings settings;  ///< without the seed
    Printed paper;
};

/// A row of the table that needs no training: one of the rules of judge::fitted_rules(), fitted and tested on the label
/// and the split of the first training.
struct RuleRow {
    std::string rule;
    std::string swarm;
    Printed paper;
};

/// A way to run the network of a row, one image at a time.
struct Timing {
    std::size_t row = 0;  ///< position in the plan's rows
    std::string device = "cpu";
    bool image_file = false;  ///< pass the image on as a PNG file, not in memory
    double paper_ms = not_printed;
};

struct Plan {
    std::vector<std::uint64_t> seeds;
    std::vector<Row> rows;
    std::vector<RuleRow> rules;
    std::vector<Timing> timings;
    std::size_t timed_samples = 0;  ///< number of snapshots over which a timing takes its median
};

/// The description of every setting of a plan, in the order of the settings in JSON.
std::vector<Setting> plan_setting_list();

/// The keys of a plan with their defaults: docs/evaluation.md explains them.
Json default_plan_json();

/// Throws UsageError that names the item and the key for a value that makes no sense.
Plan plan_from_json(const Json& json);

}  // namespace ddtool::ablation

#pragma once

#include "command.hpp"

namespace ddtool {

Command build_dataset_command();
Command compare_command();
Command completion_command();
Command convert_command();
Command dataset_command();
Command eval_command();
Command export_command();
Command info_command();
Command localize_command();
Command man_command();
Command map_command();
Command score_command();
Command settings_command();
Command simulate_command();
Command slam_command();
Command train_command();

/// All commands of ddtool.
CommandTable all_commands();

}  // namespace ddtool

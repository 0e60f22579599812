#include "commands.hpp"

namespace ddtool {

CommandTable all_commands() {
    return {build_dataset_command(), compare_command(),  completion_command(), convert_command(),
            dataset_command(),       eval_command(),     export_command(),     info_command(),
            localize_command(),      man_command(),      map_command(),        score_command(),
            settings_command(),      simulate_command(), slam_command(),       train_command()};
}

}  // namespace ddtool

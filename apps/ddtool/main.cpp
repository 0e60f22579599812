#include <exception>
#include <memory>

#include "build_dataset_command.hpp"
#include "compare_command.hpp"
#include "completion_command.hpp"
#include "convert_command.hpp"
#include "dataset_command.hpp"
#include "engine_provider.hpp"
#include "eval_command.hpp"
#include "export_command.hpp"
#include "info_command.hpp"
#include "man_command.hpp"
#include "program.hpp"
#include "score_command.hpp"
#include "settings_command.hpp"
#include "simulate_command.hpp"
#include "slam_command.hpp"
#include "surroundings.hpp"
#include "system/failure_text.hpp"
#include "system/log.hpp"
#include "train_command.hpp"

namespace ddtool {
namespace {

CommandTable all_commands() {
    CommandTable table;
    table.push_back(std::make_unique<BuildDatasetCommand>());
    table.push_back(std::make_unique<CompareCommand>());
    table.push_back(std::make_unique<CompletionCommand>());
    table.push_back(std::make_unique<ConvertCommand>());
    table.push_back(std::make_unique<DatasetCommand>());
    table.push_back(std::make_unique<EvalCommand>());
    table.push_back(std::make_unique<ExportCommand>());
    table.push_back(std::make_unique<InfoCommand>());
    table.push_back(std::make_unique<ManCommand>());
    table.push_back(std::make_unique<ScoreCommand>());
    table.push_back(std::make_unique<SettingsCommand>());
    table.push_back(std::make_unique<SimulateCommand>());
    table.push_back(std::make_unique<SlamCommand>());
    table.push_back(std::make_unique<TrainCommand>());
    return table;
}

ExitCode run_reporting_failure(int argc, char** argv) {
    try {
        reserve_standard_descriptors();
        explain_bus_errors();
#ifdef DDTOOL_WITH_TORCH
        learning::set_engine_provider(provide_engine);
#endif
        const ExitCode code = run_program(all_commands(), argc, argv);
        flush_results();
        return code;
    } catch (const Error& error) {
        log_error(error.what());
        return error.code();
    } catch (const std::exception& error) {
        log_error(failure_text(error));
        return ExitCode::failed;
    }
}

}  // namespace
}  // namespace ddtool

int main(int argc, char** argv) { return ddtool::exit_status(ddtool::run_reporting_failure(argc, argv)); }

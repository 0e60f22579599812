#include <exception>

#include "commands.hpp"
#include "engine_provider.hpp"
#include "program.hpp"
#include "surroundings.hpp"
#include "system/failure_text.hpp"
#include "system/log.hpp"

namespace ddtool {
namespace {

ExitCode run_reporting_failure(int argc, char** argv) {
    try {
        reserve_standard_descriptors();
        explain_bus_errors();
        train::set_engine_provider(provide_engine);
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

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "command.hpp"
#include "score_command.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

CommandTable all_commands() {
    CommandTable table;
    table.push_back(std::make_unique<ScoreCommand>());
    return table;
}

ExitCode run_chosen(const CommandTable& commands) {
    for (const auto& command : commands) {
        if (command->chosen()) {
            return command->execute();
        }
    }
    return ExitCode::usage;
}

int run(int argc, char** argv) {
    CLI::App program("Lidar SLAM that sees when it is degenerate, and acts on it", "ddtool");
    program.set_version_flag("--version", version_text());
    program.require_subcommand(1);
    const CommandTable commands = all_commands();
    for (const auto& command : commands) {
        command->declare(program);
    }
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return program.exit(error) == 0 ? 0 : static_cast<int>(ExitCode::usage);
    }
    return static_cast<int>(run_chosen(commands));
}

}  // namespace
}  // namespace ddtool

int main(int argc, char** argv) {
    try {
        return ddtool::run(argc, argv);
    } catch (const ddtool::Error& error) {
        std::fprintf(stderr, "ddtool: %s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ddtool: %s\n", error.what());
        return static_cast<int>(ddtool::ExitCode::failed);
    }
}

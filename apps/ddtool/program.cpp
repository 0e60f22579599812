#include "program.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "system/log.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

void add_shared_options(CLI::App& program) {
    program.set_version_flag("--version", version_text, "Print the version, the commit and those of the libraries");
    program
        .add_option_function<std::string>(
            "--log-level", [](const std::string& name) { set_log_level(log_level_named(name)); },
            "Least of what is written on stderr")
        ->type_name("debug|info|warning|error")
        ->default_str("info");
    program.add_flag_callback(
        "--quiet", [] { set_log_level(LogLevel::error); }, "Only errors on stderr: --log-level error");
    program.footer("ddtool COMMAND --help shows the options of a command and an example.");
}

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    return known.empty() ? "" : "; did you mean: " + joined(nearest_words(word, known)) + "?";
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
        const std::vector<std::string>& own = option->get_lnames();
        std::transform(own.begin(), own.end(), std::back_inserter(names), [](const auto& name) { return "--" + name; });
    }
    return names;
}

[[noreturn]] void fail_unexpected(const CLI::App& program, const std::string& word) {
    const std::vector<CLI::App*> chosen = program.get_subcommands();
    const CLI::App& app = chosen.empty() ? program : *chosen.front();
    if (word.starts_with("-")) {
        throw UsageError("unknown option '" + word + "'" +
                         did_you_mean(word.substr(0, word.find('=')), option_names(app)));
    }
    if (!chosen.empty()) {
        throw UsageError(app.get_name() + ": unexpected argument '" + word + "'");
    }
    std::vector<std::string> names;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
    }
    throw UsageError("unknown command '" + word + "'" + did_you_mean(word, names));
}

}  // namespace

ExitCode run_program(const CommandTable& commands, int argc, const char* const* argv) {
    CLI::App program("Lidar SLAM that sees when it is degenerate, and acts on it", "ddtool");
    add_shared_options(program);
    program.require_subcommand(0, 1);
    program.fallthrough();  // shared options may stand behind the command, too
    for (const auto& command : commands) {
        command->declare(program);
    }
    program.allow_extras();  // set last, for the program alone: collects the unknown, which CLI11 would only name
    try {
        program.parse(argc, argv);
    } catch (const CLI::Success& help_or_version) {
        program.exit(help_or_version);
        return ExitCode::done;
    } catch (const CLI::ParseError& error) {
        throw UsageError(error.what());
    }
    if (const std::vector<std::string> unknown = program.remaining(); !unknown.empty()) {
        fail_unexpected(program, unknown.front());
    }
    const auto chosen = std::find_if(commands.begin(), commands.end(), [](const auto& each) { return each->chosen(); });
    if (chosen == commands.end()) {
        throw UsageError("expected a command; ddtool --help lists them");
    }
    return (*chosen)->execute();
}

}  // namespace ddtool

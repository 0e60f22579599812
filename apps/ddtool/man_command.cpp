#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "program.hpp"
#include "system/atomic_file.hpp"
#include "system/folder.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

struct ManRequest {
    std::string command;
    std::string folder;
};

struct ManPage {
    std::string name;  ///< "ddtool" or "ddtool-COMMAND"
    std::string text;  ///< written with the macros of man(7)
};

/// The text in a form that roff prints unchanged: a line must not begin with a control character, and a plain minus
/// would become a hyphen.
std::string literal(const std::string& text) {
    std::string result;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\'')) {
            result += "\\&";
        }
        line_begins = c == '\n';
        result += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return result;
}

std::string section(const std::string& title, const std::string& body) {
    return body.empty() ? "" : ".SH " + title + "\n" + body;
}

std::string entry(const std::string& term, const std::string& text) {
    return ".TP\n.B " + literal(term) + "\n" + literal(text) + "\n";
}

std::string verbatim(const std::string& text) { return ".nf\n" + literal(text) + "\n.fi\n"; }

std::string term_of(const OptionText& option) {
    return option.names + (option.takes_value ? " " + option.type : "") +
           (option.default_value.empty() ? "" : " (" + option.default_value + ")");
}

std::string options_of(const HelpText& command, bool positional) {
    std::string text;
    for (const OptionText& option : command.options) {
        text += option.positional == positional ? entry(term_of(option), option.help) : "";
    }
    return text;
}

std::string entries_of_commands(const HelpText& program) {
    std::string text;
    for (const HelpText& command : program.commands) {
        text += entry(command.name, command.summary);
    }
    return text;
}

std::string synopsis_of(const HelpText& command) {
    std::string text = "ddtool " + command.name + " [OPTIONS]";
    for (const OptionText& option : command.options) {
        text += option.positional ? " " + option.names : "";
    }
    return text;
}

std::string exit_codes() {
    return entry("0", "done") + entry("1", "failed; one line on stderr says what, where, and what was expected") +
           entry("2", "wrong arguments or configuration") +
           entry("3", "finished, but something was skipped or the result is doubtful; the output says what");
}

ManPage page(const HelpText& described, const std::string& page_name, const std::string& synopsis,
             const std::string& see_also) {
    const std::string name = literal(page_name);
    return {
        page_name,
        ".TH " + name + R"( 1 "" ")" + literal(program_version()) + "\"\n" +
            section("NAME", name + " \\- " + literal(described.summary) + "\n") +
            section("SYNOPSIS", literal(synopsis) + "\n") + section("ARGUMENTS", options_of(described, true)) +
            section("OPTIONS", options_of(described, false)) + section("COMMANDS", entries_of_commands(described)) +
            section("NOTES", verbatim(described.footer)) + section("EXIT STATUS", exit_codes()) +
            section("ENVIRONMENT", entry("NO_COLOR", "Where set, messages have no colour, on a terminal neither.")) +
            section("SEE ALSO", literal(see_also) + "\n")};
}

/// The page of the program, and then a page for each of its commands.
std::vector<ManPage> man_pages(const HelpText& program) {
    std::vector<ManPage> pages{page(program, program.name, "ddtool [OPTIONS] COMMAND", "ddtool-COMMAND(1)")};
    for (const HelpText& command : program.commands) {
        pages.push_back(page(command, program.name + "-" + command.name, synopsis_of(command), "ddtool(1)"));
    }
    return pages;
}

ExitCode write_man_pages(const ManRequest& request) {
    const std::vector<ManPage> pages = man_pages(help_text(all_commands()));
    if (!request.folder.empty()) {
        const std::filesystem::path folder = made_folder(request.folder);
        for (const ManPage& page : pages) {
            write_file(folder / (page.name + ".1"), page.text);
        }
        return ExitCode::done;
    }
    const std::string wanted = pages.front().name + (request.command.empty() ? "" : "-" + request.command);
    const auto found = std::find_if(pages.begin(), pages.end(), [&](const auto& page) { return page.name == wanted; });
    if (found == pages.end()) {
        throw UsageError("man '" + request.command + "': expected a command; ddtool --help lists them");
    }
    std::cout << found->text;
    return ExitCode::done;
}

}  // namespace

Command man_command() {
    const auto request = std::make_shared<ManRequest>();
    return {.name = "man",
            .summary = "Manual pages",
            .example = "ddtool man slam | man -l -",
            .options = {{"COMMAND", &request->command, "Whose page to print; ddtool's own where not given"},
                        {"--out", &request->folder, "Instead: write every page there", "DIR"}},
            .run = [request](const Json& /*settings*/) { return write_man_pages(*request); }};
}

}  // namespace ddtool

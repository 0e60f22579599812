#include "man_page.hpp"

#include "version.hpp"

namespace ddtool {
namespace {

/// As text that roff takes literally: a line must not begin with a control character, and a minus is no hyphen.
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

std::string term_of(const CLI::Option& option) {
    const bool takes_value = option.get_items_expected_max() > 0;
    return option.get_name(option.get_positional(), true) + (takes_value ? " " + option.get_type_name() : "") +
           (option.get_default_str().empty() ? "" : " (" + option.get_default_str() + ")");
}

std::string options_of(const CLI::App& app, bool positional) {
    std::string text;
    for (const CLI::Option* option :
         app.get_options([&](const CLI::Option* each) { return each->get_positional() == positional; })) {
        text += entry(term_of(*option), option->get_description());
    }
    return text;
}

std::string commands_of(const CLI::App& program) {
    std::string text;
    for (const CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
        text += entry(command->get_name(), command->get_description());
    }
    return text;
}

std::string synopsis(const CLI::App& app) {
    std::string text = app.get_parent() == nullptr ? "ddtool [OPTIONS] COMMAND" : "ddtool " + app.get_name();
    text += app.get_parent() == nullptr ? "" : " [OPTIONS]";
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->get_positional(); })) {
        text += " " + option->get_name(true);
    }
    return literal(text) + "\n";
}

std::string exit_status() {
    return entry("0", "done") + entry("1", "failed; one line on stderr says what, where, and what was expected") +
           entry("2", "wrong arguments or configuration") +
           entry("3", "finished, but something was skipped; the output says what and how many");
}

}  // namespace

std::string man_page_name(const CLI::App& app) {
    return app.get_parent() == nullptr ? app.get_name() : app.get_parent()->get_name() + "-" + app.get_name();
}

std::string man_page(const CLI::App& app) {
    const std::string name = literal(man_page_name(app));
    return ".TH " + name + " 1 \"\" \"" + literal(program_version()) + "\"\n" +
           section("NAME", name + " \\- " + literal(app.get_description()) + "\n") +
           section("SYNOPSIS", synopsis(app)) + section("ARGUMENTS", options_of(app, true)) +
           section("OPTIONS", options_of(app, false)) + section("COMMANDS", commands_of(app)) +
           section("NOTES", verbatim(app.get_footer())) + section("EXIT STATUS", exit_status()) +
           section("ENVIRONMENT", entry("NO_COLOR", "Where set, messages have no colour, on a terminal neither.")) +
           section("SEE ALSO", literal(app.get_parent() == nullptr ? "ddtool-COMMAND(1)" : "ddtool(1)") + "\n");
}

}  // namespace ddtool

#include <iostream>
#include <memory>
#include <sstream>

#include "commands.hpp"
#include "program.hpp"

// Prints a script for bash or zsh that completes commands, options and values (zsh runs the script for bash). How a
// value is completed follows from the option's type in --help: a|b|c are choices, FILE and DIR are names of files and
// folders.

namespace ddtool {
namespace {

std::string dashed(const OptionText& option) {
    std::string names;
    for (const std::string& name : option.long_names) {
        names += (names.empty() ? "--" : " --") + name;
    }
    return names;
}

/// The shell commands that fill COMPREPLY for a value of this type, such as "FILE.tum" or "none|first|se2".
std::string reply(const std::string& type) {
    std::istringstream parts(type);
    std::string choices;
    bool files = false;
    for (std::string part; std::getline(parts, part, '|');) {
        if (part.starts_with("FILE")) {
            files = true;
        } else if (part == "DIR" || part == "FOLDER") {
            return "_ddtool_reply -d";
        } else if (type.find('|') != std::string::npos) {
            choices += (choices.empty() ? "" : " ") + part;
        }
    }
    if (!files && choices.empty()) {
        return ":";  // a number or a free name, for which there is nothing to offer
    }
    return std::string("_ddtool_reply") + (files ? " -f" : "") + (choices.empty() ? "" : " -W '" + choices + "'");
}

std::string all_options(const HelpText& command) {
    std::string all;
    for (const OptionText& option : command.options) {
        all += option.positional ? "" : " " + dashed(option);
    }
    return all;
}

std::string alternatives(std::string words, const std::string& command) {
    const std::string separator = "|" + command + ":";
    for (std::size_t blank = words.find(' '); blank != std::string::npos; blank = words.find(' ', blank)) {
        words.replace(blank, 1, separator);
    }
    return command + ":" + words;
}

/// The branches of a shell `case`, one for each option that takes a value.
std::string value_cases(const HelpText& command, const std::string& name) {
    std::string cases;
    for (const OptionText& option : command.options) {
        if (!option.positional && option.takes_value) {
            cases += "        " + alternatives(dashed(option), name) + ") " + reply(option.type) + "; return ;;\n";
        }
    }
    return cases;
}

/// The branch for all other words. All positional arguments of a command are completed alike, whatever their position.
std::string word_case(const HelpText& command) {
    std::string replies;
    for (const OptionText& option : command.options) {
        const std::string one = reply(option.type) + "; ";
        replies += option.positional && replies.find(one) == std::string::npos ? one : "";
    }
    return replies.empty() ? "" : "        " + command.name + ") " + replies + ";;\n";
}

std::string word_cases(const HelpText& program) {
    std::string cases;
    for (const HelpText& command : program.commands) {
        cases += word_case(command);
    }
    return cases;
}

std::string joined_names(const HelpText& program, const std::string& separator) {
    std::string names;
    for (const HelpText& command : program.commands) {
        names += (names.empty() ? "" : separator) + command.name;
    }
    return names;
}

std::string option_cases(const HelpText& program) {
    std::string cases = "        ':-'*) _ddtool_reply -W '" + all_options(program) + "' ;;\n";
    for (const HelpText& command : program.commands) {
        cases += "        " + command.name + ":-*) _ddtool_reply -W '" + all_options(command) + all_options(program) +
                 "' ;;\n";
    }
    return cases;
}

std::string all_value_cases(const HelpText& program) {
    std::string cases = value_cases(program, "*");
    for (const HelpText& command : program.commands) {
        cases += value_cases(command, command.name);
    }
    return cases;
}

std::string bash_completion(const HelpText& program) {
    return R"(# Written by: ddtool completion bash
_ddtool_reply() {
    local line
    [[ $1 != -[df] ]] || compopt -o filenames 2>/dev/null
    while IFS= read -r line; do COMPREPLY+=("$line"); done < <(compgen "$@" -- "$word")
}
_ddtool() {
    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command= each
    COMPREPLY=()
    # --option=value comes in three words.
    [[ $before != = ]] || before=${COMP_WORDS[COMP_CWORD - 2]}
    [[ $word != = ]] || word=
    for each in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        case $each in )" +
           joined_names(program, "|") + R"() command=$each; break ;; esac
    done
    case $command:$before in
)" + all_value_cases(program) +
           R"(    esac
    case $command:$word in
)" + option_cases(program) +
           R"(        :*) _ddtool_reply -W ')" + joined_names(program, " ") + R"(' ;;
    esac
    [[ $word != -* ]] || return
    case $command in
)" + word_cases(program) +
           R"(        *) ;;
    esac
}
complete -F _ddtool ddtool
)";
}

std::string zsh_completion(const HelpText& program) {
    return "#compdef ddtool\n# Written by: ddtool completion zsh\nautoload -U +X bashcompinit && bashcompinit\n" +
           bash_completion(program);
}

ExitCode print_completion(const std::string& shell) {
    if (shell != "bash" && shell != "zsh") {
        throw UsageError("completion '" + shell + "': expected bash or zsh");
    }
    const HelpText program = help_text(all_commands());
    std::cout << (shell == "bash" ? bash_completion(program) : zsh_completion(program));
    return ExitCode::done;
}

}  // namespace

Command completion_command() {
    const auto shell = std::make_shared<std::string>();
    return {.name = "completion",
            .summary = "Completions for a shell",
            .example = "source <(ddtool completion bash)",
            .options = {{"SHELL", shell.get(), "Whose completions to print", "bash|zsh", Presence::required}},
            .run = [shell](const Json& /*settings*/) { return print_completion(*shell); }};
}

}  // namespace ddtool

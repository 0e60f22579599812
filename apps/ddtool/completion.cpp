#include "completion.hpp"

#include <sstream>
#include <vector>

namespace ddtool {
namespace {

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App*) { return true; });
}

std::string dashed(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : option.get_lnames()) {
        names += (names.empty() ? "--" : " --") + name;
    }
    return names;
}

/// The shell commands that make COMPREPLY of a value of this type, "FILE.tum" or "none|first|se2".
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
        return ":";  // a number, a name: nothing to offer
    }
    return std::string("_ddtool_reply") + (files ? " -f" : "") + (choices.empty() ? "" : " -W '" + choices + "'");
}

std::string all_options(const CLI::App& app) {
    std::string all;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->nonpositional(); })) {
        all += " " + dashed(*option);
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

/// A case for each option that takes a value.
std::string value_cases(const CLI::App& app, const std::string& command) {
    std::string cases;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->nonpositional(); })) {
        if (option->get_items_expected_max() > 0) {
            cases += "        " + alternatives(dashed(*option), command) + ") " + reply(option->get_type_name()) +
                     "; return ;;\n";
        }
    }
    return cases;
}

/// Positionals are completed alike wherever they stand.
std::string word_case(const CLI::App& app) {
    std::string replies;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->get_positional(); })) {
        const std::string one = reply(option->get_type_name());
        replies += replies.find(one) == std::string::npos ? one + "; " : "";
    }
    return "        " + app.get_name() + ") " + replies + ";;\n";
}

std::string word_cases(const CLI::App& program) {
    std::string cases;
    for (const CLI::App* command : commands_of(program)) {
        const bool has_positionals =
            !command->get_options([](const CLI::Option* each) { return each->get_positional(); }).empty();
        cases += has_positionals ? word_case(*command) : "";
    }
    return cases;
}

std::string joined_names(const CLI::App& program, const std::string& separator) {
    std::string names;
    for (const CLI::App* command : commands_of(program)) {
        names += (names.empty() ? "" : separator) + command->get_name();
    }
    return names;
}

std::string option_cases(const CLI::App& program) {
    std::string cases = "        ':-'*) _ddtool_reply -W '" + all_options(program) + "' ;;\n";
    for (const CLI::App* command : commands_of(program)) {
        cases += "        " + command->get_name() + ":-*) _ddtool_reply -W '" + all_options(*command) +
                 all_options(program) + "' ;;\n";
    }
    return cases;
}

std::string all_value_cases(const CLI::App& program) {
    std::string cases = value_cases(program, "*");
    for (const CLI::App* command : commands_of(program)) {
        cases += value_cases(*command, command->get_name());
    }
    return cases;
}

}  // namespace

std::string bash_completion(const CLI::App& program) {
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

std::string zsh_completion(const CLI::App& program) {
    return "#compdef ddtool\n# Written by: ddtool completion zsh\nautoload -U +X bashcompinit && bashcompinit\n" +
           bash_completion(program);
}

}  // namespace ddtool

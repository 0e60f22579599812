#include "completion_command.hpp"

#include <iostream>

#include "completion.hpp"

namespace ddtool {

void CompletionCommand::add_options(CLI::App& app) {
    program_ = app.get_parent();
    app.add_option("SHELL", shell_, "Whose completions to print")->type_name("bash|zsh")->required();
}

ExitCode CompletionCommand::run(const Json& /*settings*/) {
    if (shell_ != "bash" && shell_ != "zsh") {
        throw UsageError("completion '" + shell_ + "': expected bash or zsh");
    }
    std::cout << (shell_ == "bash" ? bash_completion(*program_) : zsh_completion(*program_));
    return ExitCode::done;
}

}  // namespace ddtool

#pragma once

#include "command.hpp"

namespace ddtool {

class CompletionCommand : public Command {
public:
    CompletionCommand() : Command("completion", "Completions for a shell", "source <(ddtool completion bash)") {}

protected:
    void add_options(CLI::App& app) override;
    ExitCode run(const Json& settings) override;

private:
    const CLI::App* program_ = nullptr;
    std::string shell_;
};

}  // namespace ddtool

#pragma once

#include "command.hpp"

namespace ddtool {

class ManCommand : public Command {
public:
    ManCommand() : Command("man", "Manual pages", "ddtool man slam | man -l -") {}

protected:
    void add_options(CLI::App& app) override;
    ExitCode run(const Json& settings) override;

private:
    const CLI::App* program_ = nullptr;
    std::string command_;
    std::string folder_;
};

}  // namespace ddtool

#pragma once

#include "command.hpp"

namespace ddtool {

class SettingsCommand : public Command {
public:
    SettingsCommand()
        : Command("settings", "What each setting is, with its default and its range", "ddtool settings slam") {}

protected:
    void add_options(CLI::App& app) override;
    ExitCode run(const Json& settings) override;

private:
    std::string command_;
    bool as_json_ = false;
};

}  // namespace ddtool

#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// ddtool info: what is in a log, what a run would use of it, and what is missing.
class InfoCommand : public Command {
public:
    InfoCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string log_file_;
    bool as_json_ = false;
};

}  // namespace ddtool

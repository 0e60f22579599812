#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// ddtool score: the errors of a trajectory against a reference trajectory, relations, or both.
class ScoreCommand : public Command {
public:
    ScoreCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string trajectory_file_;
    std::string reference_file_;
    std::string relations_file_;
    std::string plot_file_;
    bool as_json_ = false;
};

}  // namespace ddtool

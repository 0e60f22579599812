#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// ddtool simulate: a drive through a world where the truth is known, as the log a robot would write.
class SimulateCommand : public Command {
public:
    SimulateCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    /// The files asked for, by what is in them.
    [[nodiscard]] Json files() const;

    std::string log_file_;
    std::string picture_file_;
    std::string truth_file_;
    std::string odometry_file_;
    bool as_json_ = false;
};

}  // namespace ddtool

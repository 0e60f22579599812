#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// Judges detectors on a data set.
class EvalCommand : public Command {
public:
    EvalCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string data_;
    std::string fit_;
    std::string out_;
    bool as_json_ = false;
};

}  // namespace ddtool

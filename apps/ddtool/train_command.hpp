#pragma once

#include <string>

#include "command.hpp"
#include "train/engine.hpp"

namespace ddtool {

/// Fits a network to a data set.
class TrainCommand : public Command {
public:
    TrainCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    train::TrainRequest request_;
    bool as_json_ = false;
};

}  // namespace ddtool

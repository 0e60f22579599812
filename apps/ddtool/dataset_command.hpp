#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// Describes a data set: what is in it, whether the labels mean something, pictures.
class DatasetCommand : public Command {
public:
    DatasetCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string folder_;
    std::string pictures_;
    bool as_json_ = false;
};

}  // namespace ddtool

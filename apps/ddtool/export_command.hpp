#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// A checkpoint as TorchScript.
class ExportCommand : public Command {
public:
    ExportCommand();

protected:
    void add_options(CLI::App& app) override;
    ExitCode run(const Json& settings) override;

private:
    std::string checkpoint_;
    std::string out_;
    bool as_json_ = false;
};

}  // namespace ddtool

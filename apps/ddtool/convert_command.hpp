#pragma once

#include <string>

#include "command.hpp"

namespace ddtool {

/// ddtool convert: any log that is read, as an MCAP file of ROS 2 messages.
class ConvertCommand : public Command {
public:
    ConvertCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string input_;
    std::string output_;
    bool as_json_ = false;
};

}  // namespace ddtool

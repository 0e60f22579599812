#pragma once

#include "command.hpp"

namespace ddtool {

/// Runs methods x worlds x seeds and reports what came out.
class CompareCommand : public Command {
public:
    CompareCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string folder_;
    std::size_t threads_ = 0;
    bool as_json_ = false;
};

}  // namespace ddtool

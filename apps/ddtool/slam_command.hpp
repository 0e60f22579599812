#pragma once

#include <cstddef>
#include <string>

#include "command.hpp"

namespace ddtool {

/// ddtool slam: from a log to a map and the way through it.
class SlamCommand : public Command {
public:
    SlamCommand();

protected:
    void add_options(CLI::App& app) override;
    [[nodiscard]] Json default_settings() const override;
    ExitCode run(const Json& settings) override;

private:
    std::string log_file_;
    std::string folder_;
    std::size_t threads_ = 0;
    bool with_snapshots_ = false;
    bool as_json_ = false;
};

}  // namespace ddtool

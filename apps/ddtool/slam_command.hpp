#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "command.hpp"
#include "log_options.hpp"
#include "system/interrupt.hpp"

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
    [[nodiscard]] std::unique_ptr<LogStream> open(const LogOptions& options, const InterruptRequest& interrupt,
                                                  LogReport& problems) const;

    std::string log_file_;
    bool follow_ = false;
    std::string folder_;
    std::size_t threads_ = 0;
    bool with_snapshots_ = false;
    bool as_json_ = false;
    CLI::Option* serve_ = nullptr;
    std::uint16_t port_ = 8765;
    std::string address_ = "127.0.0.1";
};

}  // namespace ddtool

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "log_options.hpp"
#include "run/live_run.hpp"
#include "run/live_server.hpp"
#include "system/interrupt.hpp"

namespace ddtool {

/// Where the scans of a run come from, and who may watch it.
struct LiveRunRequest {
    std::string log;
    bool follow = false;
    bool serve = false;
    std::uint16_t port = 8765;
    std::string address = "127.0.0.1";
};

/// Appends --log, which is given or may be, and --follow.
void append_input_options(std::vector<Option>& options, LiveRunRequest& request, Presence log);
/// Appends --serve and --serve-address.
void append_serve_options(std::vector<Option>& options, LiveRunRequest& request);

/// Opens the log of the request. Throws UsageError and Error.
std::unique_ptr<LogStream> open_run_log(const LiveRunRequest& request, const LogOptions& options,
                                        const InterruptRequest& interrupt, LogReport& problems);

/// The server of --serve, and the messages of the run that it sends.
struct Served {
    Served(const std::string& address, std::uint16_t port);

    LiveServer server;
    LiveRun run{server};
};

/// Null if the request asks for no server.
std::unique_ptr<Served> served_by(const LiveRunRequest& request);

/// Serves the map of a finished run until Ctrl-C, unless that has ended the run.
void serve_on(const Served* served, const InterruptRequest& interrupt);

}  // namespace ddtool

#include "live_run_options.hpp"

#include <iostream>

#include "logs/stream/live_log.hpp"
#include "system/log.hpp"

namespace ddtool {

void append_input_options(std::vector<Option>& options, LiveRunRequest& request, Presence log) {
    options.insert(options.end(), {{"--log", &request.log,
                                    log_file_help + std::string("; - is MCAP from standard input"), "FILE", log},
                                   {"--follow", &request.follow,
                                    "The log is MCAP that is still being written: wait for more, up to its footer"}});
}

void append_serve_options(std::vector<Option>& options, LiveRunRequest& request) {
    options.insert(
        options.end(),
        {{.name = "--serve",
          .value = &request.port,
          .help = "Show the run as it goes on to Foxglove or Lichtblick, at this port (0: any that is free); "
                  "after the end of the log the map stays to be seen until Ctrl-C",
          .type = "PORT",
          .alone = "8765",
          .given = &request.serve},
         {.name = "--serve-address",
          .value = &request.address,
          .help = "This machine's address that others may connect to; 127.0.0.1 is for itself alone, 0.0.0.0 all",
          .type = "ADDRESS",
          .needs = "--serve"}});
}

std::unique_ptr<LogStream> open_run_log(const LiveRunRequest& request, const LogOptions& options,
                                        const InterruptRequest& interrupt, LogReport& problems) {
    const auto stop = [&interrupt] { return interrupt.made(); };
    if (request.log != "-") {
        return request.follow ? follow_log(request.log, options, stop, problems.handler())
                              : open_log(request.log, options, problems.handler());
    }
    if (request.follow) {
        throw UsageError("--follow: expected the file that is being written; standard input ends by itself");
    }
    return open_standard_input(options, stop, problems.handler());
}

Served::Served(const std::string& address, std::uint16_t port) : server(address, port) {
    log_info("serving the run at ws://" + server.place() + " (Foxglove WebSocket)");
}

std::unique_ptr<Served> served_by(const LiveRunRequest& request) {
    return request.serve ? std::make_unique<Served>(request.address, request.port) : nullptr;
}

void serve_on(const Served* served, const InterruptRequest& interrupt) {
    if (served != nullptr && !interrupt.made()) {
        log_info("the run is over; its map is served until Ctrl-C");
        std::cout.flush();
        interrupt.wait();
    }
}

}  // namespace ddtool

#include "live_run_options.hpp"

#include <iostream>

#include "logs/stream/live_log.hpp"
#include "robot_provider.hpp"
#include "system/log.hpp"

namespace ddtool {

void append_input_options(std::vector<Option>& options, LiveRunRequest& request) {
    options.insert(
        options.end(),
        {{"--log", &request.log, log_file_help + std::string("; - is MCAP from standard input"), "FILE"},
         {"--follow", &request.follow, "The log is MCAP that is still being written: wait for more, up to its footer"},
         {.name = "--ros",
          .value = &request.ros,
          .help = "In place of a log, a robot of ROS 2 that is driving now, until Ctrl-C: its scans, odometry and "
                  "transforms are read, map -> odom and the map are published",
          .excludes = "--log"}});
}

void append_ros_arguments(std::vector<Option>& options, LiveRunRequest& request) {
    options.push_back(
        {.name = "--ros-args",
         .value = &request.ros_arguments,
         .help = "What a node of ROS 2 takes, up to the end of the line or --: -r FROM:=TO (topics, __ns, __node), "
                 "-p use_sim_time:=true, -p transform_tolerance:=SECONDS",
         .type = "WORDS",
         .needs = "--ros",
         .takes_rest = true});
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

std::string source_of(const LiveRunRequest& request, const std::string& command) {
    if (request.ros != request.log.empty()) {
        throw UsageError(command + ": expected --log FILE, or --ros for a robot that is driving now" +
                         std::string(request.ros ? ", and not both" : ""));
    }
    if (request.ros && request.follow) {
        throw UsageError("--follow: expected --log with the file that is being written; a robot is followed anyway");
    }
    return request.ros ? "ros" : request.log;
}

std::unique_ptr<RobotLink> robot_of(const LiveRunRequest& request) {
    return request.ros ? join_robot(request.ros_arguments) : nullptr;
}

std::unique_ptr<LogStream> scans_of(const LiveRunRequest& request, const LogOptions& options,
                                    const InterruptRequest& interrupt, LogReport& problems, RobotLink* robot) {
    const auto stop = [&interrupt] { return interrupt.made(); };
    if (robot != nullptr) {
        return robot->scans(options, stop, problems.handler());
    }
    if (request.log != "-") {
        return request.follow ? follow_log(request.log, options, stop, problems.handler())
                              : open_log(request.log, options, problems.handler());
    }
    if (request.follow) {
        throw UsageError("--follow: expected the file that is being written; standard input ends by itself");
    }
    return open_standard_input(options, stop, problems.handler());
}

PlacedScans placed_scans(SensorStream& scans, ParticleFilter& filter, RobotLink* robot) {
    auto* const localizer = dynamic_cast<localization::Localizer*>(&filter);
    return {scans, filter, [=]() -> std::optional<Pose2> {
                const auto told = robot != nullptr ? robot->take_initial_pose() : std::nullopt;
                if (told && localizer != nullptr && !localizer->is_mapping()) {
                    localizer->expect_at(*told);
                    return std::nullopt;
                }
                return told ? std::optional(told->pose) : std::nullopt;
            }};
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

#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "command.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "localization/localizer.hpp"
#include "log_options.hpp"
#include "run/live_run.hpp"
#include "run/live_server.hpp"
#include "run/placed_scans.hpp"
#include "run/robot_link.hpp"
#include "system/interrupt.hpp"

namespace ddtool {

/// Where the scans of a run come from, and who may watch it.
struct LiveRunRequest {
    std::string log;
    bool ros = false;
    std::vector<std::string> ros_arguments;
    bool follow = false;
    bool serve = false;
    std::uint16_t port = 8765;
    std::string address = "127.0.0.1";
};

/// Appends --log, --follow and --ros.
void append_input_options(std::vector<Option>& options, LiveRunRequest& request);
/// Appends --ros-args.
void append_ros_arguments(std::vector<Option>& options, LiveRunRequest& request);
/// Appends --serve and --serve-address.
void append_serve_options(std::vector<Option>& options, LiveRunRequest& request);

/// What the scans come from, as messages and the folder of the results name it. Throws UsageError for a request that
/// names no source, or two. \param command such as "slam"
std::string source_of(const LiveRunRequest& request, const std::string& command);
/// The robot of --ros; null if the scans come from a log.
std::unique_ptr<RobotLink> robot_of(const LiveRunRequest& request);
/// Opens the log of the request, or waits for the robot. Throws UsageError and Error.
std::unique_ptr<LogStream> scans_of(const LiveRunRequest& request, const LogOptions& options,
                                    const InterruptRequest& interrupt, LogReport& problems, RobotLink* robot);
/// The scans for a filter that hears where the people of the robot, if there is one, say that it is. In a known map the
/// localizer looks there anew; otherwise the odometry makes a step to that place. All must outlive the result.
PlacedScans placed_scans(SensorStream& scans, ParticleFilter& filter, RobotLink* robot);

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

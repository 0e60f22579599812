#include <filesystem>
#include <iostream>
#include <memory>

#include "commands.hpp"
#include "log_options.hpp"
#include "logs/stream/frame_writer.hpp"
#include "logs/stream/log_use.hpp"
#include "slam_report.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

struct ConvertRequest {
    std::string input;
    std::string output;
    bool as_json = false;
};

void check_output(const std::string& input, const std::string& output) {
    std::error_code ignored;
    if (std::filesystem::equivalent(input, output, ignored)) {
        throw UsageError(output + ": is the input; expected another file to write");
    }
}

std::string or_none(const std::string& topic) { return topic.empty() ? "none" : topic; }

std::string result_text(const LogSummary& summary, const std::string& output) {
    const std::string more = summary.more_scan_topics.empty() ? "" : ", " + joined(summary.more_scan_topics);
    return output + ": " + std::to_string(summary.scans) + " scans (" + summary.format + " " + summary.scan_topic +
           more + "), odometry " + or_none(summary.odom_topic) + ", ground truth " +
           or_none(summary.ground_truth_topic) + "\n";
}

Json result_json(const std::string& input, const LogSummary& summary, const std::string& output) {
    return {{"command", "convert"}, {"log", log_report(input, summary)}, {"files", {{"log", output}}}};
}

ExitCode convert(const ConvertRequest& request, const Json& settings) {
    check_output(request.input, request.output);
    LogReport report;
    const auto stream = open_log(request.input, log_options(settings.at("log")), report.handler());
    FrameWriter writer(request.output);
    Progress progress("convert", "scans");
    std::size_t returns = 0;
    while (const auto frame = stream->next()) {
        returns += returns_of(frame->scan);
        writer.write(*frame);
        progress.update(stream->fraction_read(), stream->summary().scans);
    }
    const LogSummary& summary = stream->summary();
    if (const std::string reason = why_unusable(summary, returns); !reason.empty()) {
        throw Error(request.input + ": " + reason + "; " + request.output + " is not written");
    }
    writer.close();
    std::cout << (request.as_json ? result_json(request.input, summary, request.output).dump(2) + "\n"
                                  : result_text(summary, request.output));
    return report.finish(summary);
}

}  // namespace

Command convert_command() {
    const auto request = std::make_shared<ConvertRequest>();
    std::vector<Option> options{
        {"IN", &request->input, log_file_help, "FILE", Presence::required},
        {"OUT", &request->output, "The MCAP file to write", "FILE.mcap", Presence::required},
    };
    append_log_options(options);
    options.push_back({"--json", &request->as_json, "Print JSON instead of a line"});
    return {.name = "convert",
            .summary = "Write any readable log as MCAP with ROS 2 messages",
            .example = "ddtool convert intel.clf.bz2 intel.mcap",
            .settings = {{"log", default_log_settings()}},
            .options = std::move(options),
            .run = [request](const Json& settings) { return convert(*request, settings); }};
}

}  // namespace ddtool

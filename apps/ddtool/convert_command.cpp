#include "convert_command.hpp"

#include <filesystem>
#include <iostream>

#include "log_options.hpp"
#include "logs/stream/frame_writer.hpp"
#include "slam_report.hpp"
#include "system/progress.hpp"

namespace ddtool {
namespace {

void check_output(const std::string& input, const std::string& output) {
    std::error_code ignored;
    if (std::filesystem::equivalent(input, output, ignored)) {
        throw UsageError(output + ": is the input; expected another file to write");
    }
}

std::string or_none(const std::string& topic) { return topic.empty() ? "none" : topic; }

std::string result_text(const LogSummary& summary, const std::string& output) {
    return output + ": " + std::to_string(summary.scans) + " scans (" + summary.format + " " + summary.scan_topic +
           "), odometry " + or_none(summary.odom_topic) + ", ground truth " + or_none(summary.ground_truth_topic) +
           "\n";
}

Json result_json(const std::string& input, const LogSummary& summary, const std::string& output) {
    return {{"command", "convert"}, {"log", log_report(input, summary)}, {"files", {{"log", output}}}};
}

}  // namespace

ConvertCommand::ConvertCommand()
    : Command("convert", "Write any readable log as MCAP with ROS 2 messages",
              "ddtool convert intel.clf.bz2 intel.mcap") {}

void ConvertCommand::add_options(CLI::App& app) {
    app.add_option("IN", input_, log_file_help)->type_name("FILE")->required();
    app.add_option("OUT", output_, "The MCAP file to write")->type_name("FILE.mcap")->required();
    for (const auto& [option, path, help] : log_option_table) {
        bind_option(app, option, path, help);
    }
    app.add_flag("--json", as_json_, "Print JSON instead of a line");
}

Json ConvertCommand::default_settings() const { return {{"log", default_log_settings()}}; }

ExitCode ConvertCommand::run(const Json& settings) {
    check_output(input_, output_);
    LogReport report;
    const auto stream = open_log(input_, log_options(settings.at("log")), report.handler());
    FrameWriter writer(output_);
    Progress progress("convert", "scans");
    while (const auto frame = stream->next()) {
        writer.write(*frame);
        progress.update(stream->fraction_read(), stream->summary().scans);
    }
    writer.close();
    const LogSummary& summary = stream->summary();
    std::cout << (as_json_ ? result_json(input_, summary, output_).dump(2) + "\n" : result_text(summary, output_));
    return report.finish(summary);
}

}  // namespace ddtool

#include "slam_report.hpp"

#include "base/text.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

std::string fixed_json(const Json& number, int decimals) { return fixed_text(number.get<double>(), decimals); }

}  // namespace

Json log_report(const std::string& file, const LogSummary& log) {
    return {{"file", file},
            {"format", log.format},
            {"scan_topic", log.scan_topic},
            {"odom_topic", log.odom_topic},
            {"ground_truth_topic", log.ground_truth_topic},
            {"scans", log.scans},
            {"odometry", log.odometry},
            {"ground_truth", log.ground_truth},
            {"problems", log.problems},
            {"bytes_lost", log.bytes_lost},
            {"assumptions", log.assumptions}};
}

Json version_report() {
    Json report = Json::object();
    for (const auto& [name, number] : versions()) {
        report[name] = number;
    }
    return report;
}

std::string slam_summary(const Json& report, const std::string& folder, const std::vector<std::string>& files) {
    const Json& run = report.at("run");
    const Json& map = run.at("map");
    const Json& cost = report.at("cost");
    std::string text = "scans    " + run.at("scans").dump() + " in " + fixed_json(run.at("duration_s"), 1) + " s; " +
                       run.at("updates").dump() + " filter updates, " + run.at("resamplings").dump() + " resamplings\n";
    text += "map      " + fixed_json(map.at("width_m"), 1) + " m x " + fixed_json(map.at("height_m"), 1) + " m, path " +
            fixed_json(run.at("path_m"), 1) + " m\n";
    if (run.contains("errors")) {
        text += "error    " + fixed_json(run.at("errors").at("ate_m").at("rmse"), 3) +
                " m rmse against the ground truth (ATE)\n";
    }
    text += "cost     " + fixed_json(cost.at("wall_s"), 1) + " s, " + fixed_json(cost.at("cpu_s"), 1) +
            " s of CPU time, " + fixed_json(1e-6 * cost.at("peak_memory_bytes").get<double>(), 0) + " MB of memory\n";
    return text + "written  " + folder + ": " + joined(files) + "\n";
}

}  // namespace ddtool

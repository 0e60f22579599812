#include "slam_report.hpp"

#include "base/text.hpp"
#include "system/process_usage.hpp"
#include "version.hpp"

namespace ddtool {
Json log_report(const std::string& file, const LogSummary& log) {
    return {{"file", file},
            {"format", log.format},
            {"scan_topic", log.scan_topic},
            {"more_scan_topics", log.more_scan_topics},
            {"odom_topic", log.odom_topic},
            {"imu_topic", log.imu_topic},
            {"odom_delay_s", log.odom_delay ? Json(log.odom_delay->late_s) : Json()},
            {"odom_delay_sigma_s", log.odom_delay ? Json(log.odom_delay->sigma_s) : Json()},
            {"odom_delay_removed_s", log.odom_delay_removed_s},
            {"ground_truth_topic", log.ground_truth_topic},
            {"scans", log.scans},
            {"odometry", log.odometry},
            {"ground_truth", log.ground_truth},
            {"problems", log.problems},
            {"bytes_lost", log.bytes_lost},
            {"damage", log.first_problems},
            {"assumptions", log.assumptions}};
}

Json version_report() {
    Json report = Json::object();
    for (const auto& [name, number] : versions()) {
        report[name] = number;
    }
    return report;
}

namespace {

std::string summary_begin(const RunSummary& run) {
    std::string text = "scans    " + std::to_string(run.scans) + " in " + fixed_text(run.duration_s, 1) + " s; " +
                       std::to_string(run.updates) + " filter updates, " + std::to_string(run.resamplings) +
                       " resamplings\n";
    text += "map      " + fixed_text(run.map_width_m, 1) + " m x " + fixed_text(run.map_height_m, 1) + " m, path " +
            fixed_text(run.path_m, 1) + " m\n";
    if (run.errors && run.errors->absolute) {
        text += "error    " + fixed_text(run.errors->absolute->translation_m.rmse, 3) +
                " m rmse against the ground truth (ATE)\n";
    }
    return text;
}

std::string summary_end(const RunCost& cost, const std::string& folder, const std::vector<std::string>& files) {
    return "cost     " + fixed_text(cost.wall_s, 1) + " s, " + fixed_text(cost.cpu_s, 1) + " s of CPU time, " +
           fixed_text(1e-6 * static_cast<double>(cost.peak_memory_bytes), 0) + " MB of memory\n" + "written  " +
           folder + ": " + joined(files) + "\n";
}

}  // namespace

std::string slam_summary(const RunSummary& run, const RunCost& cost, const std::string& self_check,
                         const std::string& folder, const std::vector<std::string>& files) {
    return summary_begin(run) + "check    " + self_check + "\n" + summary_end(cost, folder, files);
}

std::string localize_summary(const RunSummary& run, const RunCost& cost, const LocalizationCourse& course,
                             const std::string& folder, const std::vector<std::string>& files) {
    std::string place = "place    ";
    for (const auto& [name, value] : course.facts()) {
        place += (place.back() == ' ' ? "" : ", ") + name + " " + value;
    }
    return summary_begin(run) + place + "\n" + summary_end(cost, folder, files);
}

std::vector<std::string> shortfalls(const std::string& file, const LogSummary& log, bool interrupted,
                                    const FilterRun& run) {
    std::vector<std::string> lines;
    if (interrupted) {
        lines.push_back("interrupted: the results end after scan " + std::to_string(run.trajectory.size()));
    }
    if (!run.ended_early.empty()) {
        lines.push_back(file + ": " + run.ended_early + "; the results end after scan " +
                        std::to_string(run.trajectory.size()));
    }
    if (!log.has_odometry) {
        lines.push_back(
            file + ": without odometry the motion was worked out from the scans, which fails where they look alike");
    }
    return lines;
}

RunCost run_cost(std::size_t threads, std::chrono::steady_clock::time_point start) {
    const ProcessUsage usage = process_usage();
    return {.threads = threads,
            .wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
            .cpu_s = usage.cpu_s,
            .peak_memory_bytes = usage.peak_memory_bytes};
}

}  // namespace ddtool

#include <pybind11/stl.h>

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/robot/joined_scans.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "host.hpp"
#include "logs/stream/log_container.hpp"
#include "logs/stream/log_inventory.hpp"
#include "logs/stream/log_settings.hpp"
#include "logs/stream/topic_readings.hpp"
#include "scan.hpp"
#include "sources.hpp"
#include "system/log.hpp"
#include "trajectory.hpp"

namespace ddtool::python {
namespace {

/// Tells the first problems to the log, as the commands do; the others are counted by the stream.
LogProblemHandler told_problems() {
    return [told = std::size_t{0}](const LogProblem& problem) mutable {
        if (told++ < LogSummary::most_told) {
            log_warning(problem.what);
        }
    };
}

/// One reading of a log from its beginning.
class Reading {
public:
    Reading(const std::filesystem::path& path, const LogOptions& options)
        : stream_(open_log(path, options, told_problems())), joined_(*stream_) {
        stream_->tell_truth(truth_);
    }

    std::shared_ptr<HeldScan> next() {
        const std::lock_guard lock(mutex_);
        std::optional<SensorFrame> frame = joined_.next();
        if (!frame) {
            return nullptr;
        }
        const std::int64_t stamp_ns = frame->scan.stamp_ns;
        return std::make_shared<HeldScan>(HeldScan{*std::move(frame), truth_->fisher_information(stamp_ns)});
    }
    LogSummary summary() {
        const std::lock_guard lock(mutex_);
        return stream_->summary();
    }

private:
    std::mutex mutex_;
    std::shared_ptr<ScanTruth> truth_ = std::make_shared<ScanTruth>();
    std::unique_ptr<LogStream> stream_;
    JoinedScans joined_;
};

struct ImuArrays {
    py::array stamps_ns;
    py::array angular_velocity;
    py::array acceleration;
};

/// A log as Python sees it. Each iteration reads it from the beginning.
class HeldLog {
public:
    HeldLog(std::filesystem::path path, LogOptions options)
        : path_(std::move(path)), options_(std::move(options)), latest_(make_reading()) {
        for (const std::string& assumption : latest_->summary().assumptions) {
            log_warning(assumption);
        }
    }

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] std::shared_ptr<Reading> make_reading() const { return std::make_shared<Reading>(path_, options_); }
    /// The reading that was made to open the log serves the first iteration.
    std::shared_ptr<Reading> begin() {
        if (std::exchange(is_fresh_, false)) {
            return latest_;
        }
        latest_ = without_gil([&] { return make_reading(); });
        return latest_;
    }
    /// Of the latest reading, which another thread may be going on with. Call it with the GIL.
    [[nodiscard]] LogSummary summary() const {
        return without_gil([reading = latest_] { return reading->summary(); });
    }

private:
    std::filesystem::path path_;
    LogOptions options_;
    std::shared_ptr<Reading> latest_;
    bool is_fresh_ = true;
};

/// Looks for Ctrl-C at every hundredth call.
std::function<void(double)> watch_for_signals() {
    return [calls = 0](double /*share*/) mutable {
        if (++calls % 100 == 0) {
            stop_if_asked();
        }
    };
}

std::shared_ptr<HeldLog> make_log(const py::object& path, const std::optional<py::dict>& settings) {
    Json all{{"log", default_log_settings()}};
    Json given = settings ? json_from(*settings) : Json::object();
    for (const char* group :
         {"filter", "localization", "back_end", "going_on"}) {  // so that the config.json of a run fits
        given.erase(group);
    }
    merge_settings(all, given, "settings");
    const LogOptions options = log_options(all.at("log"));
    const std::filesystem::path file = existing_path(path);
    return without_gil([&] { return std::make_shared<HeldLog>(file, options); });
}

/// The odometry of a log that has it in its scans.
Trajectory odometry_in_scans(Reading& reading) {
    const std::function<void(double)> watch = watch_for_signals();
    Trajectory poses;
    while (const std::shared_ptr<HeldScan> scan = reading.next()) {
        poses.push_back({scan->frame.scan.stamp_ns, scan->frame.odom_from_robot});
        watch(0.0);
    }
    return poses;
}

std::shared_ptr<HeldTrajectory> odometry_of(const HeldLog& log, const std::string& topic) {
    const LogSummary summary = log.summary();
    if (summary.format == name_of(LogContainer::carmen) && topic.empty()) {
        return without_gil(
            [&] { return std::make_shared<HeldTrajectory>(HeldTrajectory{odometry_in_scans(*log.make_reading())}); });
    }
    const bool is_used = topic.empty() || topic == summary.odom_topic;
    const std::string wanted = topic.empty() ? summary.odom_topic : topic;
    if (wanted.empty()) {
        throw UsageError(log.path().string() +
                         ": the log has no topic of odometry; scan.odom_from_robot has what there is");
    }
    const TransformNames names = is_used ? TransformNames{summary.odom_frame, summary.robot_frame} : TransformNames{};
    return without_gil([&] {
        return std::make_shared<HeldTrajectory>(
            HeldTrajectory{read_poses(log.path(), wanted, names, {}, watch_for_signals())});
    });
}

ImuArrays imu_of(const HeldLog& log, const std::string& topic) {
    const std::string used = topic.empty() ? log.summary().imu_topic : topic;
    const std::vector<ImuReading> readings =
        without_gil([&] { return read_imu(log.path(), used, {}, watch_for_signals()); });
    const auto count = static_cast<py::ssize_t>(readings.size());
    py::array_t<std::int64_t> stamps_ns(count);
    py::array_t<double> turns({count, py::ssize_t{3}});
    py::array_t<double> accelerations({count, py::ssize_t{3}});
    for (py::ssize_t row = 0; row < count; ++row) {
        const ImuReading& reading = readings[static_cast<std::size_t>(row)];
        stamps_ns.mutable_at(row) = reading.stamp_ns;
        for (py::ssize_t axis = 0; axis < 3; ++axis) {
            turns.mutable_at(row, axis) = reading.angular_velocity_rad_per_s[axis];
            accelerations.mutable_at(row, axis) = reading.acceleration_m_per_s2[axis];
        }
    }
    return {sealed(stamps_ns), sealed(turns), sealed(accelerations)};
}

std::vector<TopicInventory> topics_of(const HeldLog& log) {
    return without_gil([&] { return take_inventory(log.path(), {}, watch_for_signals()).topics; });
}

/// A property of the summary.
template <typename Value>
auto of_summary(Value LogSummary::*member) {
    return [member](const HeldLog& log) -> Value { return log.summary().*member; };
}

void add_log_class(py::module_& module) {
    py::class_<HeldLog, std::shared_ptr<HeldLog>>(module, "Log", R"(A recorded log; open_log() makes it.

Iterating gives a Scan for each scan, those of several lidars joined; every iteration starts at the beginning. The
members that count are complete when the iteration has ended.)")
        .def("__iter__", [](HeldLog& log) { return log.begin(); })
        .def_property_readonly(
            "path", [](const HeldLog& log) { return log.path().string(); }, "The path of the log.")
        .def_property_readonly("format", of_summary(&LogSummary::format), R"("MCAP", "ROS 1 bag" and so on.)")
        .def_property_readonly("scan_topic", of_summary(&LogSummary::scan_topic), "The topic of the scans.")
        .def_property_readonly("more_scan_topics", of_summary(&LogSummary::more_scan_topics),
                               "The topics of other lidars that are used with it.")
        .def_property_readonly("odom_topic", of_summary(&LogSummary::odom_topic),
                               "The topic of the odometry; empty where there is none.")
        .def_property_readonly("odom_frame", of_summary(&LogSummary::odom_frame),
                               "The frame in which the odometry gives its poses; empty where the log does not say it.")
        .def_property_readonly("robot_frame", of_summary(&LogSummary::robot_frame),
                               "The frame whose poses they are; empty where the log does not say it.")
        .def_property_readonly("has_odometry", of_summary(&LogSummary::has_odometry), "Whether there is an odometry.")
        .def_property_readonly("imu_topic", of_summary(&LogSummary::imu_topic),
                               "The topic of the inertial sensor whose turns replace the odometry's; empty: none.")
        .def_property_readonly("ground_truth_topic", of_summary(&LogSummary::ground_truth_topic),
                               "The topic of the true poses; empty where there is none.")
        .def_property_readonly("scans", of_summary(&LogSummary::scans), "Scans read so far, of all lidars.")
        .def_property_readonly("problems", of_summary(&LogSummary::problems), "Damaged or skipped things so far.")
        .def_property_readonly("first_problems", of_summary(&LogSummary::first_problems),
                               "A line about each of the first of them.")
        .def_property_readonly("assumptions", of_summary(&LogSummary::assumptions),
                               "What the log does not say and was assumed, a line each.")
        .def("topics", &topics_of, "A Topic for each topic. Reads the log to its end.")
        .def("odometry", &odometry_of, py::arg("topic") = "",
             R"(The odometry as it was recorded, at its own stamps: a Trajectory of odom_from_robot.

topic: another topic of odometry, poses, velocities or transforms. In a CARMEN log the odometry is in the scans. Reads the
log to its end.)")
        .def("imu", &imu_of, py::arg("topic") = "",
             R"(The readings of an inertial sensor, an Imu. Reads the log to its end.

topic: of several, this one.)")
        .def("__repr__", [](const HeldLog& log) { return "<ddtool.Log '" + log.path().string() + "'>"; });
    py::class_<Reading, std::shared_ptr<Reading>>(module, "LogIterator", "One reading of a Log.")
        .def("__iter__", [](const py::object& self) { return self; })
        .def("__next__", [](Reading& reading) {
            std::shared_ptr<HeldScan> scan = without_gil([&] { return reading.next(); });
            if (!scan) {
                throw py::stop_iteration();
            }
            return scan;
        });
}

}  // namespace

void add_logs(py::module_& module) {
    py::class_<TopicInventory>(module, "Topic", "A topic of a log.")
        .def_readonly("name", &TopicInventory::topic, "Its name.")
        .def_readonly("type", &TopicInventory::type, "The type of its messages, as the log names it.")
        .def_readonly("encoding", &TopicInventory::encoding, R"(Of its messages: "cdr", "ros1", ...)")
        .def_readonly("messages", &TopicInventory::messages, "How many.")
        .def_readonly("first_ns", &TopicInventory::first_ns, "Earliest time of recording, in nanoseconds.")
        .def_readonly("last_ns", &TopicInventory::last_ns, "Latest time of recording, in nanoseconds.")
        .def_property_readonly(
            "frames",
            [](const TopicInventory& topic) {
                return std::vector<std::string>(topic.frames.begin(), topic.frames.end());
            },
            R"("laser", "odom -> base"; only of types that ddtool reads.)")
        .def_property_readonly("rate_hz", &TopicInventory::rate_hz,
                               "Messages per second; NaN if there are fewer than two.")
        .def("__repr__", [](const TopicInventory& topic) {
            return "<ddtool.Topic '" + topic.topic + "' " + topic.type + ", " + std::to_string(topic.messages) + ">";
        });
    py::class_<ImuArrays>(module, "Imu", "Readings of an inertial sensor, a row each, in the sensor's frame.")
        .def_readonly("stamps_ns", &ImuArrays::stamps_ns, "(N,) int64, nanoseconds.")
        .def_readonly("angular_velocity", &ImuArrays::angular_velocity, "(N, 3) rad/s about x, y and z.")
        .def_readonly("acceleration", &ImuArrays::acceleration, "(N, 3) m/s^2 along x, y and z; upwards at rest.");
    add_log_class(module);
    module.def("open_log", &make_log, py::arg("path"), py::kw_only(), py::arg("settings") = py::none(),
               R"(Opens a log of any format that ddtool reads, recognised by its content.

path: an MCAP file, a ROS 1 bag, a rosbag2 folder or .db3 file, or a CARMEN log; also compressed or in a tar archive.
settings: those of the group "log" by their names in JSON, nested or with dots: {"log.scan_topic": "/front"}. Other
    groups of config.json of a run are left aside.)");
}

}  // namespace ddtool::python

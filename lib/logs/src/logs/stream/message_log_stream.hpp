#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "ddtool/logs/log_stream.hpp"
#include "ddtool/robot/scan_truth.hpp"
#include "logs/containers/message_source.hpp"
#include "logs/stream/log_plan.hpp"
#include "logs/stream/odometry_resets.hpp"
#include "logs/stream/pose_track.hpp"

namespace ddtool {

/// The frames of a log that consists of messages. The log is read twice, first to choose the topics and to learn what
/// its readings mean, and then for the frames. If the log can be opened only once, this is done with its beginning,
/// which is kept in memory meanwhile. A scan waits
/// until an odometry message (and a ground truth message) after it in the file reaches its stamp, and then gets the
/// interpolated pose. If no interval contains its stamp (at the ends of the log, and in gaps), it gets the nearest
/// odometry, and no ground truth.
class MessageLogStream : public LogStream {
public:
    /// The number of scans that may wait at a time. If there are more, the first one is returned without waiting
    /// longer.
    static constexpr std::size_t max_waiting = 256;
    /// If the nearest odometry is further away in time than this, it is reported as a problem.
    static constexpr double max_odometry_gap_s = 0.5;

    using OpenSource = std::function<std::unique_ptr<MessageSource>(LogProblemHandler)>;

    enum class Opening { twice, once };

    /// Surveys the log immediately.
    /// \param open opens the log; it is called twice, or once with Opening::once
    /// \param format, file name the log in the summary and in messages
    /// Throws as plan_log() does.
    MessageLogStream(const OpenSource& open, Opening opening, std::string format, std::string file,
                     const LogOptions& options, LogProblemHandler on_problem);

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override { return source_->fraction_read(); }
    void tell_truth(const std::shared_ptr<ScanTruth>& truth) override { truth_ = truth; }

private:
    struct WaitingScan {
        SensorFrame frame;
        std::optional<Eigen::Matrix3d> information;  ///< from the simulator, if it has arrived
        bool has_odometry = false;
        bool has_ground_truth = false;
        bool has_information = false;
    };

    /// Set plan_ and source_; source_ then begins again with the first message.
    void survey(const OpenSource& open, const LogOptions& options);
    void survey_once(const OpenSource& open, const LogOptions& options);
    void take(const McapMessage& message);
    void take_scan(const McapMessage& message);
    void take_odometry(const McapMessage& message);
    void take_ground_truth(const McapMessage& message);
    void take_information(const McapMessage& message);
    /// Reports the message if not.
    bool has_rotation(const PoseReading& reading, const McapMessage& message);
    /// Null if the frame has no known place on the robot.
    [[nodiscard]] const Eigen::Isometry3d* mounting_of(const std::string& frame_id) const;
    [[nodiscard]] bool is_odometry(const PoseReading& reading) const;
    [[nodiscard]] bool first_is_ready() const;
    SensorFrame release_first();
    [[nodiscard]] Pose2 odometry_at(std::int64_t stamp_ns);
    void report_message(const McapMessage& message, const std::string& what);

    std::string file_;
    LogPlan plan_;
    std::unique_ptr<MessageSource> source_;
    std::deque<WaitingScan> waiting_;
    StampReader scan_times_;
    StampReader odom_times_;
    StampReader ground_truth_times_;
    OdometryResets resets_;
    PoseTrack odometry_;
    PoseTrack ground_truth_;
    std::shared_ptr<ScanTruth> truth_;
    bool ended_ = false;
};

}  // namespace ddtool

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
#include "logs/stream/frame_watch.hpp"
#include "logs/stream/gyro_odometry.hpp"
#include "logs/stream/gyro_trial.hpp"
#include "logs/stream/interleaved_paths.hpp"
#include "logs/stream/log_plan.hpp"
#include "logs/stream/odometry_gaps.hpp"
#include "logs/stream/odometry_resets.hpp"
#include "logs/stream/pose_reader.hpp"
#include "logs/stream/pose_track.hpp"

namespace ddtool {

/// The frames of a log that consists of messages. The log is read twice, first to choose the topics and to learn what
/// its readings mean, and then for the frames; in between, its beginning is read to learn when the beams of a scan were
/// measured. If the log can be opened only once, this is done with its beginning,
/// which is kept in memory meanwhile. A scan waits
/// until an odometry message after it in the file reaches its last beam (and a ground truth message its stamp), and
/// then gets the interpolated poses. If no interval contains its stamp (at the ends of the log), it gets the nearest
/// odometry, and no ground truth. What the odometry says of the motion before each frame is in its odom_step.
class MessageLogStream : public LogStream {
public:
    /// The number of scans that may wait at a time. If there are more, the first one is returned without waiting
    /// longer.
    static constexpr std::size_t max_waiting = 256;
    /// If the nearest odometry is further away in time than this, a scan has none.
    static constexpr double max_odometry_gap_s = OdometryGaps::least_gap_s;
    /// So many scans at most are looked at before the first frame.
    static constexpr std::size_t most_rehearsed = 5000;

    using OpenSource = std::function<std::unique_ptr<MessageSource>(LogProblemHandler)>;

    enum class Opening {
        twice,
        once,
        /// Once, and the messages are those of a robot that is driving now: the survey takes less time, a scan does not
        /// wait for the next pose of the odometry if that comes soon, but takes the latest motion to go on, nor longer
        /// than longest_live_wait_ns of recording for any, and no frame waits for what comes after it.
        live,
    };
    /// In so short a time a robot that brakes as hard as it can is a millimetre or two from where it would have been.
    static constexpr std::int64_t longest_guess_ns = 50'000'000;
    static constexpr std::int64_t longest_live_wait_ns = 500'000'000;

    /// Surveys the log immediately.
    /// \param open opens the log; it is called two or three times, or once with Opening::once
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
        std::int64_t measured_ns = 0;                ///< when its last beam was
        std::int64_t since_ns = 0;                   ///< when it was recorded
        std::optional<Eigen::Matrix3d> information;  ///< from the simulator, if it has arrived
        bool has_odometry = false;
        bool has_ground_truth = false;
        bool has_information = false;
    };

    /// Consecutive scans that have no odometry.
    struct LostPart {
        std::size_t first_scan = 0;
        std::size_t scans = 0;
        double farthest_s = 0.0;
    };

    /// What the clouds hold.
    struct Clouds {
        std::size_t read = 0;
        std::size_t in_band = 0;  ///< of these, with a point in the band of heights
        HeightBand band;          ///< of the last one
        HeightBand heights;       ///< in which the points are, until one is in the band
    };

    /// For a rehearsal.
    MessageLogStream(LogPlan plan, std::unique_ptr<MessageSource> source, std::string file);

    void rehearse(const OpenSource& open);
    void start_clocks();
    void take_off_lag();
    /// Set plan_ and source_; source_ then begins again with the first message.
    void survey(const OpenSource& open, const LogOptions& options);
    void survey_once(const OpenSource& open, const LogOptions& options, SurveyExtent extent);
    void take(const McapMessage& message);
    void take_scan(const McapMessage& message, std::size_t lidar);
    void take_cloud(const McapMessage& message, std::size_t lidar);
    /// Puts a scan among those that wait for their odometry.
    void wait(SensorFrame frame);
    /// The source has no more messages.
    void end();
    void take_odometry(const McapMessage& message);
    void take_rates(const McapMessage& message);
    void add_odometry(const StampedPose& odom_from_robot);
    void release_odometry(bool at_end);
    /// Takes the turns from the gyro if the scans show that they are better.
    void judge_gyro();
    [[nodiscard]] bool is_settled() const;
    void take_ground_truth(const McapMessage& message);
    void take_information(const McapMessage& message);
    /// Reports the message if not.
    bool has_rotation(const PoseReading& reading, const McapMessage& message);
    /// Null if the frame of the message has no known place on the robot, which is then reported.
    const Eigen::Isometry3d* mounting_of(const std::string& frame_id, const McapMessage& message);
    /// Whether the reading of the odometry's frames is from the publisher that is used.
    [[nodiscard]] bool is_of_used_path(const PoseReading& reading, const McapMessage& message);
    [[nodiscard]] bool is_odometry(const PoseReading& reading) const;
    [[nodiscard]] bool first_is_ready() const;
    [[nodiscard]] bool is_near_odometry(const WaitingScan& scan) const;
    std::optional<SensorFrame> read_frame();
    SensorFrame release_first();
    void time_beams(SensorFrame& frame);
    void take_odometry_at(SensorFrame& frame);
    void end_lost_part();
    void report_gap(const OdometryGaps::Gap& gap, const McapMessage& message);
    void report_message(const McapMessage& message, const std::string& what);

    std::string file_;
    LogPlan plan_;
    std::unique_ptr<MessageSource> source_;
    std::deque<WaitingScan> waiting_;
    std::int64_t now_ns_ = 0;  ///< when the latest message was recorded
    bool is_live_ = false;
    PoseReader odometry_reader_;
    InterleavedPaths paths_;
    std::vector<SweepTimer> sweep_timers_;  ///< of each lidar
    std::vector<StampReader> scan_times_;   ///< of each lidar
    StampReader odom_times_;
    StampReader ground_truth_times_;
    OdometryResets resets_;
    GyroOdometry gyro_odometry_;
    GyroTrial gyro_trial_;
    bool gyro_is_judged_ = false;
    bool is_read_once_ = false;
    OdometryGaps gaps_;
    PoseTrack odometry_;
    std::optional<std::int64_t> last_odometry_ns_;
    std::optional<std::int64_t> last_scan_ns_;  ///< of the last frame released
    std::size_t released_ = 0;                  ///< frames
    LostPart lost_;
    bool was_lost_ = false;  ///< whether the last frame released had no odometry
    FrameWatch watch_;
    PoseTrack ground_truth_;
    std::shared_ptr<ScanTruth> truth_;
    bool ended_ = false;
    Clouds clouds_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/line_reader.hpp"
#include "logs/messages/carmen_message.hpp"
#include "logs/stream/frame_watch.hpp"
#include "logs/stream/log_container.hpp"
#include "logs/stream/no_return.hpp"
#include "logs/stream/odometry_gaps.hpp"
#include "logs/stream/odometry_resets.hpp"
#include "logs/stream/pose_track.hpp"
#include "logs/stream/range_unit.hpp"
#include "logs/stream/stamp_survey.hpp"
#include "logs/stream/sweep_timer.hpp"
#include "logs/stream/turn_lag.hpp"
#include "logs/stream/way_scale.hpp"

namespace ddtool {

/// The frames of a CARMEN log: its FLASER or ROBOTLASER1 lines, whichever comes first, with the odometry in each line.
/// A reading means no return if it is at least as large as the smallest of these: the maximum range that the log states
/// (in ROBOTLASER1, or as PARAM robot_front_laser_max), the least code for a missing return that was found in
/// the first scans, and 80 m, the reach of the SICK lasers of these logs (whose codes are 81.83 to 81.91). To find the
/// codes, the constructor reads the first scans. It then reads the file once more, to compare the odometry with the
/// scans.
class CarmenStream : public LogStream {
public:
    static constexpr std::size_t scans_read_ahead = 1000;
    /// So many scans at most are read ahead to know the odometry where its stamps have a delay taken off.
    static constexpr std::size_t most_waiting = 256;

    CarmenStream(const FoundLog& log, LogOptions options, LogProblemHandler on_problem);

    std::optional<SensorFrame> next() override;
    [[nodiscard]] double fraction_read() const override;

private:
    struct Ahead {
        SensorFrame frame;  ///< with the stamp and the readings of the line
        std::int64_t recorded_ns = 0;
        std::string jump;  ///< of the odometry before this line; empty: there is none
    };

    void read_ahead();
    void judge_odometry(const FoundLog& log);
    void note_delay(std::optional<TurnLag> lag);
    void take_delayed_odometry(SensorFrame& frame, std::int64_t logged_ns);
    void choose_times();
    void expect_ranges();
    void note_assumptions();
    void find_sweep(const ScanRate& rate);
    /// \param logged_ns the stamp as it is in the line
    void time_beams(SensorFrame& frame, std::int64_t logged_ns);
    std::optional<SensorFrame> next_read();
    std::optional<Ahead> read_frame();
    std::optional<Ahead> take_line(std::string_view line);
    std::optional<Ahead> take_scan(const std::string& name, std::string_view words);
    std::int64_t recorded_ns(const CarmenScan& message);
    void take_parameter(std::string_view words);
    [[nodiscard]] Pose2 robot_from_laser(const CarmenScan& message) const;
    void set_no_returns(LaserScan& scan) const;
    [[noreturn]] void fail_without_scans() const;

    std::string file_;
    LogOptions options_;
    LineReader lines_;
    std::deque<Ahead> ahead_;
    StampReader times_;
    std::optional<std::int64_t> logger_start_ns_;  ///< ipc time minus logger time of the first scan
    OdometryResets resets_;
    bool stamps_are_plain_ = false;   ///< the times of the lines are stamps, which need no rule
    std::int64_t odom_delay_ns_ = 0;  ///< taken off the odometry's stamps
    PoseTrack odometry_;              ///< by the times of the lines, with all jumps taken out
    OdometryGaps unknown_motion_;     ///< by the times of the lines
    std::int64_t last_logged_ns_ = 0;
    std::optional<std::int64_t> last_wanted_ns_;  ///< for which the odometry was taken last
    FrameWatch watch_;
    std::optional<Pose2> mounting_;      ///< PARAM robot_frontlaser_*
    std::optional<double> range_max_m_;  ///< PARAM robot_front_laser_max
    NoReturns no_returns_;
    SweepTimer sweep_timer_;
    std::size_t in_degrees_ = 0;   ///< scans whose angles were in degrees
    std::string other_scan_name_;  ///< seen, but not the one in use
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/message_source.hpp"
#include "logs/messages/message_decoder.hpp"
#include "logs/stream/gyro_survey.hpp"
#include "logs/stream/no_return.hpp"
#include "logs/stream/range_unit.hpp"
#include "logs/stream/scan_change.hpp"
#include "logs/stream/scan_rate.hpp"
#include "logs/stream/stamp_survey.hpp"
#include "logs/stream/track_survey.hpp"
#include "logs/stream/transform_tree.hpp"
#include "logs/stream/turn_lag.hpp"
#include "logs/stream/way_scale.hpp"

namespace ddtool {

/// The names of the parent and the child of a transform.
using FramePair = std::pair<std::string, std::string>;

struct TopicSurvey {
    static constexpr std::size_t max_frames = 64;  ///< because in a damaged log every message may name another one

    std::string topic;
    std::string type;  ///< the schema's name
    MessageKind kind = MessageKind::other;
    std::vector<std::string> scan_frames;  ///< of scans and clouds, in the order in which they are first named
    std::size_t scans = 0;                 ///< messages of scans and clouds
    std::size_t scans_read = 0;            ///< of these, those that could be decoded
    std::size_t scans_with_ranges = 0;     ///< of these, those with a range that is a positive number, or with points
    std::size_t scans_in_degrees = 0;      ///< of these, those whose angles are not in radians
    std::string first_fault;               ///< of the first that could not be decoded
    RangeUnit unit;                        ///< of all scans
    RangePiles piles;                      ///< of all scans
    ScanChange change;                     ///< of all scans or clouds
    ClockLag clock;                        ///< of all scans or clouds with a stamp
    StampSurvey stamps;                    ///< of all scans or clouds
    ScanRate rate;                         ///< of all scans
    GyroSurvey gyro;                       ///< of inertial messages
    ScanTurns turns;                       ///< of the scans in the first of the frames
    ScanWay way;                           ///< likewise
    std::map<FramePair, TrackSurvey> tracks;  ///< of odometry, poses and transforms
};

/// The topics and transforms of a log, or of its beginning.
struct LogSurvey {
    bool is_whole = false;            ///< the log has been looked through to its end
    std::vector<TopicSurvey> topics;  ///< by name
    bool has_information = false;     ///< is_information() is true for a channel
    /// The latest transform of each frame, by transform_namespace() of its topic.
    std::map<std::string, TransformTree> transforms;
};

/// How much of a log is looked through before its first frame.
enum class SurveyExtent {
    whole,
    /// The first ten seconds, for a log that can be read only once. If there is no scan yet, or if a topic that the
    /// options name is missing, further, to the end if necessary.
    beginning,
    /// For a robot that waits to be mapped: until there have been scans for three seconds, and odometry or transforms
    /// with them; without these, scans for ten seconds. Also further for topics that the options name.
    soon,
};

/// Point clouds are looked at only in a log without laser scans before them, or if the options name a topic of them; of
/// a log that can be read only once, at most 256 MiB of them unless what is needed is not there yet. Memory does not
/// grow with the log.
LogSurvey survey_log(MessageSource& source, SurveyExtent extent, const LogOptions& options);

}  // namespace ddtool

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/message_source.hpp"
#include "logs/messages/message_decoder.hpp"
#include "logs/stream/no_return.hpp"
#include "logs/stream/transform_tree.hpp"

namespace ddtool {

struct TopicSurvey {
    std::string topic;
    std::string type;  ///< the schema's name
    MessageKind kind = MessageKind::other;
    std::string frame_id;        ///< of the first message
    std::string child_frame_id;  ///< of the first message
    RangePiles piles;            ///< of all scans
};

/// The topics and transforms of a log, or of its beginning.
struct LogSurvey {
    std::vector<TopicSurvey> topics;  ///< by name
    bool has_information = false;     ///< is_information() is true for a channel
    TransformTree transforms;         ///< the latest transform of each frame
};

/// How much of a log is looked through before its first frame.
enum class SurveyExtent {
    whole,
    /// The first ten seconds, for a log that can be read only once. If there is no scan yet, or if a topic that the
    /// options name is missing, further, to the end if necessary.
    beginning,
};

/// Memory does not grow with the log.
LogSurvey survey_log(MessageSource& source, SurveyExtent extent, const LogOptions& options);

}  // namespace ddtool

#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"
#include "logs/containers/message_source.hpp"
#include "logs/messages/message_decoder.hpp"
#include "logs/stream/transform_tree.hpp"

namespace ddtool {

struct TopicSurvey {
    std::string topic;
    std::string type;  ///< the schema's name
    MessageKind kind = MessageKind::other;
    std::string frame_id;        ///< of the first message
    std::string child_frame_id;  ///< of the first message
};

/// What the beginning of a log holds.
struct LogSurvey {
    std::vector<TopicSurvey> topics;  ///< by name
    bool has_information = false;     ///< is_information() is so of a channel
    TransformTree transforms;         ///< the latest of each frame
};

/// Reads a log's first ten seconds; further, if need be to its end, until there is a scan and every topic that the
/// options name. Memory does not grow with the log.
LogSurvey survey_log(MessageSource& source, const LogOptions& options);

}  // namespace ddtool

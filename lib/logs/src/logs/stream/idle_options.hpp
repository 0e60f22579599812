#pragma once

#include <string>
#include <vector>

#include "ddtool/logs/log_stream.hpp"

namespace ddtool {

/// What of the things that options are about is used of a log.
struct UsedOfLog {
    bool clouds = false;
    bool echoes = false;  ///< scans with several echoes of a beam
    bool odometry = false;
};

/// One line for each option that is given but changes nothing, because the log has not what it is about.
std::vector<std::string> options_without_effect(const LogOptions& options, const UsedOfLog& used);

}  // namespace ddtool

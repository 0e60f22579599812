#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ddtool {

/// Something in a log that was skipped; reading goes on after it.
struct LogProblem {
    std::string what;              ///< one line: file, place, what was found, what was expected
    std::uint64_t offset = 0;      ///< where in the file, in bytes
    std::uint64_t bytes_lost = 0;  ///< of the file, known to be skipped or missing; 0 where nothing is or unknown
};

using LogProblemHandler = std::function<void(const LogProblem&)>;

}  // namespace ddtool

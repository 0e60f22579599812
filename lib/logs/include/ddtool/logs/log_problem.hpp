#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace ddtool {

/// Something in a log that had to be skipped; reading continues after it.
struct LogProblem {
    std::string what;              ///< one line: file, place, what was found, what was expected
    std::uint64_t offset = 0;      ///< where in the file, in bytes
    std::uint64_t bytes_lost = 0;  ///< bytes of the file known to be skipped or missing; 0 if unknown
};

/// Is called with each problem, on the thread that reads the log. An empty handler ignores problems.
class LogProblemHandler : std::function<void(const LogProblem&)> {
public:
    using function::function;

    void operator()(const LogProblem& problem) const {
        if (*this) {
            function::operator()(problem);
        }
    }
};

}  // namespace ddtool

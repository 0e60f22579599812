#pragma once

#include <chrono>
#include <string>

namespace ddtool {

/// One line on stderr, redrawn: what, share done, rate, time left. Silent when stderr is not a terminal, and with
/// --quiet.
class Progress {
public:
    using Clock = std::chrono::steady_clock;

    /// unit: what is counted, e.g. "scans".
    Progress(std::string what, std::string unit);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// fraction_done in 0..1, where 0 stands for unknown, too; count: units done so far. Cheap: redraws a few times a
    /// second at most.
    void update(double fraction_done, std::size_t count);

private:
    void draw(double fraction_done, std::size_t count, Clock::time_point now);

    std::string what_;
    std::string unit_;
    bool shown_;
    bool drawn_ = false;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_ = start_;
};

/// "1:05" or "2:03:09" for a number of seconds; "?" when it is negative, absurdly long or no number.
std::string format_duration(double seconds);

}  // namespace ddtool

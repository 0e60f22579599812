#pragma once

#include <chrono>
#include <string>

namespace ddtool {

/// A line on stderr that is redrawn in place: what is being done, the share done, the rate, the time left. Nothing is
/// shown if stderr is not a terminal, or with --quiet. For one thread at a time.
class Progress {
public:
    using Clock = std::chrono::steady_clock;

    /// \param what the name of the work, at the start of the line
    /// \param unit what is counted, e.g. "scans"
    Progress(std::string what, std::string unit);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// \param fraction_done the share done, 0..1; 0 also means that the share is unknown
    /// \param count the units done so far
    /// Cheap to call often: the line is redrawn at most a few times per second.
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

/// A duration as text: "1:05" or "2:03:09"; "?" if it is negative, not finite, or absurdly long.
std::string format_duration(double seconds);

}  // namespace ddtool

#include "system/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "system/log.hpp"

namespace ddtool {
namespace {

constexpr auto redraw_interval = std::chrono::milliseconds(200);

}  // namespace

Progress::Progress(std::string what, std::string unit)
    : what_(std::move(what)),
      unit_(std::move(unit)),
      shown_(::isatty(STDERR_FILENO) != 0 && log_shows(LogLevel::info)) {}

Progress::~Progress() {
    if (drawn_) {
        std::fputs("\r\033[K", stderr);
    }
}

void Progress::update(double fraction_done, std::size_t count) {
    if (!shown_) {
        return;
    }
    const auto now = Clock::now();
    if (now - last_ >= redraw_interval) {
        last_ = now;
        draw(std::clamp(fraction_done, 0.0, 1.0), count, now);
    }
}

void Progress::draw(double fraction_done, std::size_t count, Clock::time_point now) {
    const double elapsed_s = std::chrono::duration<double>(now - start_).count();
    const double rate = static_cast<double>(count) / elapsed_s;
    if (fraction_done > 0.0) {
        const double left_s = elapsed_s * (1.0 - fraction_done) / fraction_done;
        std::fprintf(stderr, "\r\033[K%s %3.0f %%  %zu %s  %.0f %s/s  %s left", what_.c_str(), 100.0 * fraction_done,
                     count, unit_.c_str(), rate, unit_.c_str(), format_duration(left_s).c_str());
    } else {
        std::fprintf(stderr, "\r\033[K%s  %zu %s  %.0f %s/s", what_.c_str(), count, unit_.c_str(), rate, unit_.c_str());
    }
    drawn_ = true;
}

std::string format_duration(double seconds) {
    constexpr double longest_s = 1e9;
    if (!(seconds >= 0.0 && seconds < longest_s)) {
        return "?";
    }
    const long total = std::lround(seconds);
    char text[48];
    if (total >= 3600) {
        std::snprintf(text, sizeof text, "%ld:%02ld:%02ld", total / 3600, total / 60 % 60, total % 60);
    } else {
        std::snprintf(text, sizeof text, "%ld:%02ld", total / 60, total % 60);
    }
    return text;
}

}  // namespace ddtool

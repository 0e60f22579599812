#include "logs/stream/clock_lag.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr std::size_t most_samples = 4096;
constexpr std::size_t least_samples = 10;
constexpr double widest_spread_s = 0.1;
constexpr double largest_s = 1e9;  ///< larger ones come from damaged stamps

double seconds(std::int64_t ns) { return 1e-9 * static_cast<double>(ns); }

}  // namespace

void ClockLag::add(std::int64_t stamp_ns, std::int64_t recorded_ns) {
    first_ns_ = seen_ == 0 ? stamp_ns : std::min(first_ns_, stamp_ns);
    last_ns_ = seen_ == 0 ? stamp_ns : std::max(last_ns_, stamp_ns);
    if (seen_++ % every_ != 0) {
        return;
    }
    if (samples_.size() == most_samples) {
        for (std::size_t i = 0; i < most_samples / 2; ++i) {
            samples_[i] = samples_[2 * i];
        }
        samples_.resize(most_samples / 2);
        every_ *= 2;
    }
    samples_.push_back({seconds(recorded_ns), seconds(stamp_ns) - seconds(recorded_ns)});
}

ClockLag ClockLag::of_recording(std::int64_t first_ns, std::int64_t last_ns) {
    ClockLag lag;
    const double step_ns = (static_cast<double>(last_ns) - static_cast<double>(first_ns)) / least_samples;
    for (std::size_t i = 0; i < least_samples; ++i) {
        const std::int64_t time_ns = first_ns + static_cast<std::int64_t>(static_cast<double>(i) * step_ns);
        lag.add(time_ns, time_ns);
    }
    lag.add(last_ns, last_ns);
    return lag;
}

bool ClockLag::overlap(const ClockLag& a, const ClockLag& b, double offset_s) {
    return a.seen_ > 0 && b.seen_ > 0 && seconds(a.first_ns_) + offset_s <= seconds(b.last_ns_) &&
           seconds(b.first_ns_) <= seconds(a.last_ns_) + offset_s;
}

std::optional<double> ClockLag::offset_s(const ClockLag& a, const ClockLag& b) {
    std::vector<Sample> others = a.samples_;
    std::ranges::stable_sort(others, {}, &Sample::recorded_s);
    if (others.empty() || b.samples_.size() < least_samples) {
        return std::nullopt;
    }
    std::vector<double> ahead_s;
    for (const Sample& sample : b.samples_) {
        auto next = std::ranges::lower_bound(others, sample.recorded_s, {}, &Sample::recorded_s);
        const bool before_is_nearer =
            next == others.end() || (next != others.begin() &&
                                     sample.recorded_s - (next - 1)->recorded_s < next->recorded_s - sample.recorded_s);
        next -= before_is_nearer ? 1 : 0;
        ahead_s.push_back(sample.ahead_s - next->ahead_s);
    }
    std::ranges::sort(ahead_s);
    const std::size_t tail = ahead_s.size() / 20;
    const double spread_s = ahead_s[ahead_s.size() - 1 - tail] - ahead_s[tail];
    const double median_s = ahead_s[ahead_s.size() / 2];
    const bool is_constant = spread_s < widest_spread_s && std::abs(median_s) < largest_s;
    return is_constant ? std::optional(median_s) : std::nullopt;
}

}  // namespace ddtool

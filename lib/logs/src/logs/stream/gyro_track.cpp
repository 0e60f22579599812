#include "logs/stream/gyro_track.hpp"
#include "robot/stamps.hpp"

#include <algorithm>

namespace ddtool {
namespace {}  // namespace

void GyroTrack::add(std::int64_t stamp_ns, double rate_rad_per_s) {
    if (!samples_.empty() && stamp_ns < samples_.back().stamp_ns) {
        samples_.clear();
    }
    Sample sample{stamp_ns, rate_rad_per_s, 0.0, 0};
    if (!samples_.empty()) {
        const Sample& before = samples_.back();
        const double since_s = seconds_between(before.stamp_ns, stamp_ns);
        sample.heading_rad = before.heading_rad + 0.5 * since_s * (before.rate_rad_per_s + rate_rad_per_s);
        sample.piece = before.piece + (since_s > longest_gap_s ? 1 : 0);
    }
    samples_.push_back(sample);
    if (samples_.size() > most_samples) {
        samples_.pop_front();
    }
}

bool GyroTrack::reaches(std::int64_t stamp_ns) const {
    return !samples_.empty() && samples_.back().stamp_ns >= stamp_ns;
}

std::optional<double> GyroTrack::turn_rad(std::int64_t from_ns, std::int64_t to_ns) const {
    const std::optional<Heading> from = heading_at(from_ns);
    const std::optional<Heading> to = heading_at(to_ns);
    return from && to && from->piece == to->piece ? std::optional(to->rad - from->rad) : std::nullopt;
}

std::optional<GyroTrack::Heading> GyroTrack::heading_at(std::int64_t stamp_ns) const {
    const auto after = std::ranges::lower_bound(samples_, stamp_ns, {}, &Sample::stamp_ns);
    if (after == samples_.end()) {
        return std::nullopt;
    }
    if (after->stamp_ns == stamp_ns) {
        return Heading{after->heading_rad, after->piece};
    }
    if (after == samples_.begin() || (after - 1)->piece != after->piece) {
        return std::nullopt;
    }
    const Sample& before = *(after - 1);
    const double share = seconds_between(before.stamp_ns, stamp_ns) / seconds_between(before.stamp_ns, after->stamp_ns);
    return Heading{before.heading_rad + share * (after->heading_rad - before.heading_rad), after->piece};
}

}  // namespace ddtool

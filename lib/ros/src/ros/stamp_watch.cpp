#include "ros/stamp_watch.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

constexpr auto least_jump_ns = static_cast<std::int64_t>(1e9 * StampWatch::least_jump_s);
/// A clock of a robot that is not set drifts by less than this part of the time.
constexpr std::int64_t drift_share = 1000;
/// A robot's clock is not set more often in a run that is of any use.
constexpr std::size_t most_offsets = 64;

}  // namespace

bool StampWatch::goes_on(const Source& source, std::int64_t stamp_ns, std::int64_t arrived_ns) const {
    if (stamp_ns < source.last_ns - least_jump_ns) {
        return false;
    }
    return simulated_ || arrived_ns - stamp_ns > source.least_lag_ns - least_jump_ns;
}

/// Of the known offsets the latest with which the stamps go on, as those of another source do already, or a new one.
std::int64_t StampWatch::offset_after_jump(const Source& source, std::int64_t stamp_ns, std::int64_t arrived_ns) {
    const auto fits = [&](std::int64_t offset_ns) {
        const std::int64_t with_offset_ns = stamp_ns + offset_ns;
        const std::int64_t ahead_ns =
            simulated_ ? with_offset_ns - source.last_ns : (arrived_ns - with_offset_ns) - source.least_lag_ns;
        return goes_on(source, with_offset_ns, arrived_ns) && std::abs(ahead_ns) < least_jump_ns;
    };
    if (const auto known = std::find_if(offsets_.rbegin(), offsets_.rend(), fits); known != offsets_.rend()) {
        return *known;
    }
    const std::int64_t expected_ns =
        simulated_ ? source.last_ns + source.interval_ns : arrived_ns - source.least_lag_ns;
    const std::int64_t offset_ns = expected_ns - stamp_ns;
    offsets_.push_back(offset_ns);
    if (offsets_.size() > most_offsets) {
        offsets_.erase(offsets_.begin());
    }
    return offset_ns;
}

std::int64_t StampWatch::offset_ns(const std::string& source, std::int64_t stamp_ns, std::int64_t arrived_ns) {
    new_jump_.reset();
    const auto [place, is_new] = sources_.try_emplace(source);
    Source& known = place->second;
    if (is_new) {
        known.offset_ns = offsets_.back();
        known.last_ns = stamp_ns + known.offset_ns;
        known.least_lag_ns = arrived_ns - known.last_ns;
    } else if (!goes_on(known, stamp_ns + known.offset_ns, arrived_ns)) {
        const std::size_t offsets = offsets_.size();
        const std::int64_t before_ns = known.offset_ns;
        known.offset_ns = offset_after_jump(known, stamp_ns, arrived_ns);
        if (offsets_.size() != offsets) {
            new_jump_ = {source, 1e-9 * static_cast<double>(before_ns - known.offset_ns)};
        }
    }
    const std::int64_t with_offset_ns = stamp_ns + known.offset_ns;
    const std::int64_t passed_ns = std::max<std::int64_t>(arrived_ns - known.arrived_ns, 0);
    const std::int64_t forgotten_ns = is_new ? 0 : passed_ns / drift_share;
    known.least_lag_ns = std::min(known.least_lag_ns + forgotten_ns, arrived_ns - with_offset_ns);
    known.interval_ns = std::max<std::int64_t>(with_offset_ns - known.last_ns, 0);
    known.last_ns = std::max(known.last_ns, with_offset_ns);
    known.arrived_ns = arrived_ns;
    return known.offset_ns;
}

std::int64_t StampWatch::offset_of(const std::string& source) const {
    const auto found = sources_.find(source);
    return found == sources_.end() ? 0 : found->second.offset_ns;
}

}  // namespace ddtool

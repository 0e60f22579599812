#include "logs/stream/stamp_survey.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/text.hpp"

namespace ddtool {
namespace {

double in_seconds(std::int64_t ns) { return 1e-9 * static_cast<double>(ns); }

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

std::int64_t stamp_difference(std::int64_t a_ns, std::int64_t b_ns) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a_ns) - static_cast<std::uint64_t>(b_ns));
}

std::int64_t stamp_sum(std::int64_t a_ns, std::int64_t b_ns) {
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(a_ns) + static_cast<std::uint64_t>(b_ns));
}

void StampSurvey::add(std::int64_t stamp_ns, bool has_stamp, std::int64_t recorded_ns) {
    first_recorded_ns_ = messages_ == 0 ? recorded_ns : std::min(first_recorded_ns_, recorded_ns);
    last_recorded_ns_ = messages_ == 0 ? recorded_ns : std::max(last_recorded_ns_, recorded_ns);
    if (messages_ > 0) {
        recorded_equal_ += recorded_ns == recorded_before_ns_ ? 1 : 0;
        recorded_back_ += recorded_ns < recorded_before_ns_ ? 1 : 0;
    }
    recorded_in_seconds_ = recorded_in_seconds_ && recorded_ns % units_[0].ns == 0;
    ++messages_;
    if (has_stamp) {
        take_step(stamp_ns, recorded_ns);
    } else {
        missing_in_front_ += stamps_ == 0 ? 1 : 0;
    }
    recorded_before_ns_ = recorded_ns;
}

void StampSurvey::take_step(std::int64_t stamp_ns, std::int64_t recorded_ns) {
    if (stamps_++ == 0) {
        first_stamp_ns_ = least_stamp_ns_ = most_stamp_ns_ = stamp_ns;
        first_ahead_ns_ = stamp_difference(stamp_ns, recorded_ns);
    } else {
        const double stamp_s = in_seconds(stamp_difference(stamp_ns, stamp_before_ns_));
        const double recorded_s = in_seconds(stamp_difference(recorded_ns, recorded_before_ns_));
        ++steps_;
        equal_ += stamp_ns == stamp_before_ns_ ? 1 : 0;
        sum_ss_ += stamp_s * stamp_s;
        sum_sr_ += stamp_s * recorded_s;
        sum_rr_ += recorded_s * recorded_s;
        for (Period& period : periods_) {
            // After a wrap the stamps have gone on by less than a quarter of the period, and by as much as the times of
            // recording if these go on at all.
            const double period_s = in_seconds(period.ns);
            const double on_s = stamp_s + period_s;
            const bool is_wrap = on_s >= 0.0 && on_s < period_s / 4.0 &&
                                 (recorded_s <= 0.0 || std::abs(on_s - recorded_s) < std::min(1.0, period_s / 4.0) ||
                                  recorded_s > period_s / 2.0);
            period.times += stamp_s < 0.0 && is_wrap ? 1 : 0;
            period.unlike_it += stamp_s < 0.0 && !is_wrap ? 1 : 0;
        }
    }
    for (Unit& unit : units_) {
        unit.divides_all = unit.divides_all && stamp_ns % unit.ns == 0;
    }
    least_stamp_ns_ = std::min(least_stamp_ns_, stamp_ns);
    most_stamp_ns_ = std::max(most_stamp_ns_, stamp_ns);
    stamp_before_ns_ = stamp_ns;
}

/// Whether the times of recording can stand for stamps: they go on, nearly without steps back, and are not rounded.
bool StampSurvey::recording_is_good() const {
    const std::size_t steps = messages_ - std::min<std::size_t>(messages_, 1);
    const bool rounded = recorded_in_seconds_ && share(recorded_equal_, steps) > 0.1;
    return last_recorded_ns_ > first_recorded_ns_ && share(recorded_equal_, steps) < 0.5 &&
           share(recorded_back_, steps) < 0.02 && !rounded;
}

/// The root mean square of what the steps of the stamps differ from those of the recording, the clocks of which may run
/// at different speeds.
double StampSurvey::rounding_error_s() const {
    const double speed = sum_rr_ > 0.0 ? sum_sr_ / sum_rr_ : 0.0;
    return std::sqrt(std::max(0.0, sum_ss_ - speed * sum_sr_) / static_cast<double>(std::max<std::size_t>(steps_, 1)));
}

/// The largest unit of which all stamps are multiples and that explains why some are equal. If the share p of the steps
/// is one unit u and the others are none, and the messages came regularly, the steps are wrong by u sqrt(p (1 - p)).
const StampSurvey::Unit* StampSurvey::rounded_to() const {
    constexpr std::size_t least_steps = 10;
    const double p = 1.0 - share(equal_, steps_);
    if (steps_ < least_steps || p > 0.9 || p <= 0.0) {
        return nullptr;
    }
    const auto* const unit = std::ranges::find_if(units_, &Unit::divides_all);
    if (unit == units_.end()) {
        return nullptr;
    }
    if (!recording_is_good()) {  // nothing to compare with: only whole seconds are a sign by themselves
        return unit == units_.begin() ? unit : nullptr;
    }
    return rounding_error_s() > 0.5 * in_seconds(unit->ns) * std::sqrt(p * (1.0 - p)) ? unit : nullptr;
}

const StampSurvey::Period* StampSurvey::wrapped_at() const {
    const auto* const period = std::ranges::find_if(periods_, [&](const Period& each) {
        return least_stamp_ns_ >= 0 && most_stamp_ns_ < each.ns && each.times > 0 && each.unlike_it == 0;
    });
    return period == periods_.end() ? nullptr : period;
}

StampRule StampSurvey::rule(const std::string& what) const {
    constexpr std::int64_t begins_at_zero_ns = 10'000'000'000;
    constexpr std::int64_t other_clock_ns = 1'000'000'000;
    StampRule rule;
    rule.zero_is_a_stamp = missing_in_front_ > 0 && stamps_ > 0 && first_stamp_ns_ > 0 &&
                           first_stamp_ns_ < begins_at_zero_ns && missing_in_front_ + stamps_ == messages_;
    rule.ahead_ns =
        stamps_ > 0 && std::abs(in_seconds(first_ahead_ns_)) > in_seconds(other_clock_ns) ? first_ahead_ns_ : 0;
    std::string found;
    if (stamps_ == 0) {
        found = "all 0";
    } else if (steps_ > 1 && least_stamp_ns_ == most_stamp_ns_) {
        found = "all equal";
    } else if (const Period* period = wrapped_at()) {
        found = "wrapped: they start again at 0 after " + fixed_text(in_seconds(period->ns), 1) +
                " s (2^32 of their counter's units)";
        rule.period_ns = recording_is_good() ? 0 : period->ns;
    } else if (const Unit* unit = rounded_to()) {
        found = unit == units_.begin() ? "rounded to whole seconds" : "rounded to 0.1 s";
    }
    if (found.empty() || messages_ < 2) {
        return rule;
    }
    rule.zero_is_a_stamp = false;
    const std::string text = "the stamps of " + what + " are " + found;
    if (recording_is_good()) {
        rule.from_recording = true;
        rule.assumption = text + "; their times of recording are used";
    } else if (rule.period_ns > 0) {
        rule.assumption = text + "; they are counted on";
    } else {
        rule.fault = text + ", and their times of recording are no better; rates and durations are unknown";
    }
    return rule;
}

std::int64_t StampReader::time_ns(std::int64_t stamp_ns, bool has_stamp, std::int64_t recorded_ns) {
    if (rule_.from_recording) {
        return recorded_ns;
    }
    if (!has_stamp) {
        return rule_.zero_is_a_stamp ? 0 : stamp_sum(recorded_ns, rule_.ahead_ns);
    }
    if (rule_.period_ns > 0) {
        passed_ns_ = stamp_sum(passed_ns_, stamp_ns < before_ns_ ? rule_.period_ns : 0);
        before_ns_ = stamp_ns;
    }
    return stamp_sum(stamp_ns, passed_ns_);
}

}  // namespace ddtool

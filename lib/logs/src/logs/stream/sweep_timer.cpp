#include "logs/stream/sweep_timer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/text.hpp"
#include "robot/sweep.hpp"

namespace ddtool {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi;
/// The lidars of robots turn between 4 and 100 times a second. Scans that come more rarely were thinned out, and their
/// rate says nothing.
constexpr double longest_turn_s = 0.34;
constexpr double shortest_turn_s = 1.0 / 250.0;
/// The beams of a scan may take this much longer than the time to the next scan, because both are rounded and vary.
constexpr double tolerance = 1.1;

bool is_alike(double a_s, double b_s) { return std::abs(a_s - b_s) <= (tolerance - 1.0) * std::abs(b_s); }

void add_candidate(std::vector<double>& turns_s, double turn_s) {
    if (std::ranges::none_of(turns_s, [&](double known_s) { return is_alike(turn_s, known_s); })) {
        turns_s.push_back(turn_s);
    }
}

/// Between two beams; 0 for a damaged scan, which covers many turns.
double increment_s(const LaserScan& scan, double turn_s) {
    const double increment_rad = std::abs(scan.angle_increment_rad);
    const bool is_sound = increment_rad * static_cast<double>(scan.ranges_m.size()) < 2.0 * turn_rad;
    return is_sound ? turn_s * increment_rad / turn_rad : 0.0;
}

std::string ms_text(double seconds) { return fixed_text(1e3 * seconds, 1) + " ms"; }

}  // namespace

SweepTiming find_sweep_timing(const ScanRate& rate) {
    SweepTiming timing;
    timing.view_rad = std::min(rate.view_rad(), turn_rad);
    const double period_s = rate.period_s();
    const bool turns_once_a_scan = period_s >= shortest_turn_s && period_s <= longest_turn_s;
    const double stated_s = rate.time_increment_s();
    const double increment_rad = rate.angle_increment_rad();
    const double stated_turn_s = increment_rad > 0.0 ? stated_s * turn_rad / increment_rad : 0.0;
    const double stated_sweep_s = increment_rad > 0.0 ? stated_s * rate.view_rad() / increment_rad : 0.0;
    const double most_s = period_s > 0.0 ? tolerance * period_s : longest_turn_s;
    const bool can_be_true = stated_turn_s > 0.0 && stated_sweep_s <= most_s && stated_sweep_s <= 1.0;
    if (can_be_true) {
        timing.turns_s.insert(timing.turns_s.begin(), stated_turn_s);
        add_candidate(timing.turns_s, -stated_turn_s);
    }
    if (turns_once_a_scan) {
        const bool is_assumed = stated_s != 0.0 && !can_be_true;
        if (is_assumed) {
            timing.turns_s.insert(timing.turns_s.begin(), period_s);
        }
        add_candidate(timing.turns_s, period_s);
        add_candidate(timing.turns_s, -period_s);
    }
    if (stated_s != 0.0 && !can_be_true) {
        timing.doubt = "the scans state " + fixed_text(1e3 * stated_s, 4) + " ms between two beams, and so " +
                       ms_text(stated_sweep_s) + " for all of a scan, which cannot be: the next scan begins after " +
                       ms_text(period_s) + "; the beams are taken to be measured " +
                       (turns_once_a_scan ? "in the time to the next scan" : "all at once");
    }
    return timing;
}

SweepTimer::SweepTimer(const SweepTiming& timing)
    : turns_s_(timing.turns_s), view_rad_(timing.view_rad), trial_(timing.turns_s.size()) {}

double SweepTimer::middle_s() const { return 0.5 * std::abs(turns_s_[trial_.chosen()]) * view_rad_ / turn_rad; }

double SweepTimer::longest_s(const LaserScan& scan) const {
    const double longest_turn =
        std::abs(std::ranges::max(turns_s_, {}, [](double turn_s) { return std::abs(turn_s); }));
    return sweep_duration_s(scan, increment_s(scan, longest_turn));
}

bool SweepTimer::is_settled() const { return turns_s_.size() == 1 || trial_.pairs() >= SweepTrial::most_pairs; }

void SweepTimer::settle() {
    turns_s_ = {turns_s_[trial_.chosen()]};
    trial_ = SweepTrial(1);
}

bool SweepTimer::apply(SensorFrame& frame, const std::function<std::optional<Pose2>(double)>& odom_from_robot) {
    LaserScan& scan = frame.scan;
    const std::size_t before = trial_.chosen();
    std::vector<std::vector<Pose2>> sweeps;
    for (const double turn_s : turns_s_) {
        sweeps.push_back(sweep_of(scan, increment_s(scan, turn_s), odom_from_robot));
    }
    if (!is_settled()) {
        trial_.add(frame, sweeps);
    }
    const double turn_s = turns_s_[trial_.chosen()];
    frame.sweep = std::move(sweeps[trial_.chosen()]);
    scan.time_increment_s = std::abs(increment_s(scan, turn_s));
    if (turn_s < 0.0) {
        reverse_beams(scan);
        std::ranges::reverse(frame.sweep);
    }
    return trial_.chosen() != before;
}

std::string SweepTimer::finding() const {
    if (trial_.chosen() == 0) {
        return "";
    }
    const auto text = [](double turn_s) {
        return turn_s == 0.0 ? "all at once"
                             : "one after the other" + std::string(turn_s < 0.0 ? ", from the last to the first" : "") +
                                   ", a turn in " + ms_text(std::abs(turn_s));
    };
    return "the beams of a scan are measured " + text(turns_s_[trial_.chosen()]) + ", not " + text(turns_s_.front()) +
           ": so the scans agree better that were taken while the robot moved differently (" +
           std::to_string(trial_.pairs()) + " pairs of scans)";
}

}  // namespace ddtool

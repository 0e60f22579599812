#include "localization/lost_watch.hpp"

#include <algorithm>
#include <cmath>

#include "base/squared.hpp"
#include "ddtool/filter/scan_noise.hpp"

namespace ddtool::localization {
namespace {

/// How many scans usual_support counts for, and how much what is explained varies: people, doors, things that were
/// moved.
constexpr double assumed_scans = 20.0;
constexpr double remembered_scans = 200.0;
constexpr double usual_sd = 0.07;
constexpr double lost_sd = 0.15;
/// What is explained where the robot is lost is at least so much below what is usual.
constexpr double least_gap = 0.2;
/// The evidence of a single scan is limited, since what stands before the lidar for a moment is no proof.
constexpr double most_evidence = 4.0;
/// The probability of getting lost on a metre of way: a wheel that slips, a robot that is carried away.
constexpr double lost_per_m = 1e-3;
constexpr double most_log_odds = 5.0;

double log_normal(double value, double mean, double sd) { return -0.5 * squared((value - mean) / sd) - std::log(sd); }

double log_odds_of(double probability) { return std::log(probability / (1.0 - probability)); }

}  // namespace

LostWatch::LostWatch(double probability)
    : log_odds_(log_odds_of(probability)), usual_(usual_support), scans_(assumed_scans) {}

void LostWatch::restart(double probability) { log_odds_ = log_odds_of(probability); }

double LostWatch::probability() const { return 1.0 / (1.0 + std::exp(-log_odds_)); }

void LostWatch::add(double support, double way_m) {
    const double before = probability();
    log_odds_ = log_odds_of(before + (1.0 - before) * std::min(1.0, lost_per_m * way_m));
    const double found = log_normal(std::min(support, usual_), usual_, usual_sd);
    const double lost_mean = std::min(support_by_chance, usual_ - least_gap);
    const double lost = log_normal(std::max(support, lost_mean), lost_mean, lost_sd);
    const double evidence = std::clamp(lost - found, -most_evidence, most_evidence);
    log_odds_ += std::min(1.0, way_m / independent_scan_m) * evidence;
    log_odds_ = std::clamp(log_odds_, -most_log_odds, most_log_odds);
    if (probability() < 0.1) {
        scans_ = std::min(scans_ + 1.0, remembered_scans);
        usual_ += (support - usual_) / scans_;
    }
}

}  // namespace ddtool::localization

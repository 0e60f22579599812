#include "run/localization_course.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>

#include "base/text.hpp"

namespace ddtool {
namespace {

constexpr std::size_t most_spells = 1000;

double seconds(std::int64_t from_ns, std::int64_t to_ns) { return 1e-9 * static_cast<double>(to_ns - from_ns); }

}  // namespace

LocalizationCourse::LocalizationCourse(const std::filesystem::path& file) : file_(file) {
    file_.write(
        [](std::ostream& out) { out << "stamp_ns,probability,lost,mode_weight,modes,particles,support,searched\n"; });
}

void LocalizationCourse::add(const Update& update, const localization::Standing& standing) {
    const std::int64_t stamp_ns = update.matched.stamp_ns;
    std::array<char, 160> row{};
    std::snprintf(row.data(), row.size(), "%lld,%.6g,%.6g,%.6g,%zu,%zu,%.6g,%d\n", static_cast<long long>(stamp_ns),
                  standing.probability, standing.lost, standing.mode_weight, standing.modes, standing.particles,
                  standing.support, standing.searched ? 1 : 0);
    file_.write([&](std::ostream& out) { out << row.data(); });
    if (updates_ == 0) {
        start_ns_ = stamp_ns;
    }
    ++updates_;
    way_m_ += std::hypot(update.matched.odometry_motion.x_m, update.matched.odometry_motion.y_m);
    support_ += standing.support;
    searches_ += standing.searched ? 1 : 0;
    most_modes_ = std::max(most_modes_, standing.modes);
    particles_ += standing.particles;
    if (standing.probability >= sure) {
        ++sure_updates_;
        if (!way_until_sure_m_) {
            way_until_sure_m_ = way_m_;
        }
    }
    // Before the robot was found for the first time, it is not lost but not found yet.
    was_sure_ = was_sure_ || standing.probability >= sure;
    const bool is_lost = was_sure_ && standing.lost >= lost;
    if (is_lost && !is_lost_ && spells_.size() < most_spells) {
        spells_.push_back({stamp_ns, stamp_ns});
    } else if (is_lost && !spells_.empty()) {
        spells_.back().to_ns = stamp_ns;
    }
    is_lost_ = is_lost;
    last_ = standing;
}

Json LocalizationCourse::json() const {
    Json spells = Json::array();
    for (const Spell& spell : spells_) {
        spells.push_back({{"from_s", seconds(start_ns_, spell.from_ns)}, {"to_s", seconds(start_ns_, spell.to_ns)}});
    }
    const double updates = std::max(1.0, static_cast<double>(updates_));
    return {{"sure_after_m", way_until_sure_m_ ? Json(*way_until_sure_m_) : Json()},
            {"sure_share", static_cast<double>(sure_updates_) / updates},
            {"last_probability", last_.probability},
            {"mean_support", support_ / updates},
            {"mean_particles", static_cast<double>(particles_) / updates},
            {"most_modes", most_modes_},
            {"searches", searches_},
            {"lost", spells}};
}

std::vector<report::Fact> LocalizationCourse::facts() const {
    return {
        {"sure of its place",
         fixed_text(100.0 * static_cast<double>(sure_updates_) / std::max(1.0, static_cast<double>(updates_)), 1) +
             " % of the updates"},
        {"first sure after", way_until_sure_m_ ? fixed_text(*way_until_sure_m_, 1) + " m" : "never"},
        {"lost", std::to_string(spells_.size()) + " times"},
        {"particles", fixed_text(static_cast<double>(particles_) / std::max(1.0, static_cast<double>(updates_)), 0)}};
}

std::vector<std::string> LocalizationCourse::doubts() const {
    std::vector<std::string> lines;
    if (!way_until_sure_m_) {
        lines.push_back("the robot was never sure of its place in the map: no pose had a probability of " +
                        fixed_text(sure, 1));
        return lines;
    }
    if (last_.probability < lost) {
        lines.push_back("at the end the pose has a probability of " + fixed_text(last_.probability, 2) + " only");
    }
    for (const Spell& spell : spells_) {
        constexpr std::size_t most_told = 3;
        if (lines.size() == most_told) {
            lines.push_back("and lost more often: run.json lists all " + std::to_string(spells_.size()) + " times");
            break;
        }
        lines.push_back("lost from " + fixed_text(seconds(start_ns_, spell.from_ns), 1) + " s to " +
                        fixed_text(seconds(start_ns_, spell.to_ns), 1) +
                        " s: the scans did not fit the map where the robot seemed to be");
    }
    return lines;
}

}  // namespace ddtool

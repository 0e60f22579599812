#pragma once

namespace ddtool::localization {

/// What a map explains of what is seen at the right place, before anything was learnt of it, and at a wrong place that
/// a search and a match have chosen.
inline constexpr double usual_support = 0.9;
inline constexpr double support_by_chance = 0.5;

/// How probable it is that the robot is not where the filter has it, from how much of each scan the map explains there
/// (ScanFit::support()), against what it explained where the robot was found: a hidden Markov model of two states.
/// Scans that are near each other err together, so that each counts by the way driven since the last one.
class LostWatch {
public:
    /// \param probability before the first scan
    explicit LostWatch(double probability);

    /// The robot is taken to be somewhere else, and lost there with this probability.
    void restart(double probability);

    /// Takes in a scan.
    /// \param way_m driven since the last one
    void add(double support, double way_m);
    [[nodiscard]] double probability() const;

private:
    double log_odds_ = 0.0;
    double usual_ = 0.0;  ///< support where the robot is not lost
    double scans_ = 0.0;  ///< that usual_ was learnt from
};

}  // namespace ddtool::localization

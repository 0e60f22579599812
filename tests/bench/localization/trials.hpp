#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "drives.hpp"
#include "localization/localization_settings.hpp"

namespace ddtool::localization_bench {

/// How far the poses as known at each update are from the truth, not aligned.
struct Errors {
    double ate_m = 0.0;  ///< rmse
    double worst_m = 0.0;
    double nees_position = 0.0;    ///< mean squared error in units of the covariance; 2 if that is right
    double nees_heading = 0.0;     ///< 1 if it is right
    double within_position = 0.0;  ///< share of the poses that lie within the 95 % ellipse of their covariance
    double within_heading = 0.0;   ///< the same for the heading
};

/// A localisation of a drive from its start to its end, from a start that was given to 2 cm and half a degree.
struct Followed {
    Errors in_building;  ///< against the truth, laid on the map as a whole
    Errors in_map;       ///< against where the map, which may be bent, has the place: MadeMap::in_map()
    double sure_share = 0.0;
    double cpu_ms = 0.0;  ///< per update
    double particles = 0.0;
};
Followed follow(const MadeMap& map, const std::vector<SensorFrame>& frames,
                const localization::LocalizationSettings& settings);

/// A start somewhere, without a pose.
struct Started {
    std::optional<double>
        right_after_m;               ///< the way until the place was right, with a probability of .9, and stayed so
    bool right = false;              ///< at the end
    bool confidently_wrong = false;  ///< at some time the probability was above .9 at a wrong place
};
/// \param from the frame at which the robot wakes up
Started start_anywhere(const MadeMap& map, const std::vector<SensorFrame>& frames, std::size_t from, double way_m,
                       const localization::LocalizationSettings& settings);

/// A robot that is carried away.
struct Kidnapped {
    std::optional<double>
        noticed_after_m;  ///< the way until the probability of the pose fell below a half, or it was right
    std::optional<double> mended_after_m;  ///< the way until the place was right with a probability of .9
};
/// The robot drives from the frame `from` for some metres, and goes on at the frame `to`, while its odometry notices
/// nothing.
Kidnapped kidnap(const MadeMap& map, const std::vector<SensorFrame>& frames, std::size_t from, std::size_t to,
                 double way_m, const localization::LocalizationSettings& settings);

}  // namespace ddtool::localization_bench

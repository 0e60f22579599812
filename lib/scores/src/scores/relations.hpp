#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "scores/association.hpp"
#include "scores/error_statistics.hpp"

namespace ddtool {

/// The true motion between two times, checked by hand (Kuemmerle et al. 2009, "On measuring the accuracy of SLAM
/// algorithms").
struct Relation {
    std::int64_t from_ns = 0;
    std::int64_t to_ns = 0;
    Pose2 motion;  ///< the pose at to_ns seen from the one at from_ns
};

/// Reads lines of the form "time1_s time2_s x_m y_m z_m roll_rad pitch_rad yaw_rad"; '#' begins a comment. x, y and yaw
/// are kept. Throws Error naming the file, the line and what was expected.
std::vector<Relation> read_relations(const std::filesystem::path& path);

/// Statistics of the errors of relations.
struct RelationStatistics {
    ErrorStatistics translation_m;
    ErrorStatistics rotation_deg;
};

struct RelationErrors {
    /// Relations between times that are less apart than this are short: they tell of noise. Those more apart than
    /// least_long_s are long: they tell of maps that are bent or torn, which the mean of all hides, since most are
    /// short.
    static constexpr double most_short_s = 5.0;
    static constexpr double least_long_s = 60.0;

    std::vector<std::int64_t> from_ns;  ///< from_ns of the relations that were scored, in their order
    std::vector<double> errors_m;       ///< one per relation that was scored
    std::vector<double> errors_deg;
    RelationStatistics all;
    std::optional<RelationStatistics> short_ones;  ///< empty: there are none
    std::optional<RelationStatistics> long_ones;
    std::size_t skipped = 0;  ///< relations that have a time for which the trajectory has no pose
};

/// The error of each relation: with x_i, x_j the poses of the trajectory at its two times and d the true motion, it is
/// the pose inverse(inverse(x_i) * x_j) * d, whose length and absolute angle are averaged separately (Kuemmerle et al.,
/// eq. 4 and 5). The pose at a time is the one nearest to it within max_time_difference_s.
RelationErrors score_relations(const Trajectory& trajectory, const std::vector<Relation>& relations,
                               double max_time_difference_s = default_max_time_difference_s);

}  // namespace ddtool

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"
#include "system/npy_file.hpp"

namespace ddtool::dataset {

/// The rules by which labels are made (docs/dataset.md).
enum class LabelRule : std::size_t { dispersion, fisher };
inline constexpr std::array<const char*, 2> label_rule_names{"dispersion", "fisher"};

/// How samples are divided into parts for training and testing.
enum class Split : std::size_t { paper, held_out };
inline constexpr std::array<const char*, 2> split_names{"paper", "held_out"};

enum class Part : std::int16_t { unused, train, validation, test };
inline constexpr std::array<const char*, 4> part_names{"unused", "train", "validation", "test"};

/// The class of a label. It is unknown if the source does not allow to determine it.
enum class Label : std::int16_t { unknown = -1, not_degenerate = 0, degenerate = 1 };
inline constexpr std::array<const char*, 2> class_names{"not_degenerate", "degenerate"};

inline constexpr std::array<LabelRule, 2> all_label_rules{LabelRule::dispersion, LabelRule::fisher};
inline constexpr std::array<Split, 2> all_splits{Split::paper, Split::held_out};
/// All parts except `unused`.
inline constexpr std::array<Part, 3> used_parts{Part::train, Part::validation, Part::test};

template <typename Enum>
constexpr std::size_t index_of(Enum value) {
    return static_cast<std::size_t>(value);
}

inline std::string name_of(LabelRule rule) { return label_rule_names[index_of(rule)]; }
inline std::string name_of(Split split) { return split_names[index_of(split)]; }
inline std::string name_of(Part part) { return part_names[index_of(part)]; }

/// One row of shard-*.samples.npy, with the layout of the file. Values that are not known for a source are NaN.
struct SampleRecord {
    std::int64_t stamp_ns = 0;
    std::uint64_t update = 0;          ///< number of filter updates before this one
    std::uint64_t first_particle = 0;  ///< row in the particles of the same shard
    Pose2 odometry_motion;             ///< since the last update, in the robot's previous frame
    Pose2 true_pose;                   ///< world_from_robot
    /// The information about (x, y, theta) that the scan contains, in the robot's frame: xx, xy, xt, yy, yt, tt, in
    /// 1/m^2, 1/m and 1.
    std::array<double, 6> information{};
    double range_sd_m = 0.0;          ///< standard deviation of a range of the scan's median length
    double weak_sd_m = 0.0;           ///< Cramer-Rao bound along the weakest direction
    double weak_direction_rad = 0.0;  ///< in the robot's frame
    double strong_sd_m = 0.0;         ///< along the strongest direction
    double odometry_sd_m = 0.0;       ///< of the odometry over the step, along the weakest direction
    /// R over the accumulated log-likelihood, its increment, the match score, and the normalised weight.
    std::array<double, 4> dispersion{};
    std::uint32_t source = 0;  ///< position in the manifest's sources
    std::uint32_t run = 0;     ///< position in the manifest's runs
    std::uint32_t particle_count = 0;
    std::array<Label, 2> label{Label::unknown, Label::unknown};  ///< by LabelRule
    std::array<std::array<Part, 2>, 2> part{};                   ///< by LabelRule, Split

    [[nodiscard]] Label label_of(LabelRule rule) const { return label[index_of(rule)]; }
    [[nodiscard]] Part part_of(LabelRule rule, Split split) const { return part[index_of(rule)][index_of(split)]; }
};
static_assert(sizeof(SampleRecord) == 216 && sizeof(SnapshotParticle) == 13 * sizeof(double),
              "the layouts are those of the files");

/// The dtypes of the two files of a shard.
const NpyFormat& samples_format();
const NpyFormat& particles_format();

}  // namespace ddtool::dataset

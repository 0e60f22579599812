#pragma once

#include <span>
#include <string_view>

#include "scores/association.hpp"

namespace ddtool {

/// The rigid motion by which the estimate is moved before it is compared with the reference.
enum class Alignment {
    none,
    first,  ///< the first poses of both are laid onto each other (evo: --align_origin)
    se2,    ///< least squares over all positions, without scale (Umeyama 1991; evo: --align)
};

/// The alignment named "none", "first" or "se2"; throws UsageError for any other name.
Alignment parse_alignment(std::string_view name);

/// The motion that moves the estimate into the frame of the reference. There must be at least one pair. se2 is
/// Umeyama's solution in two dimensions in closed form; unlike the three-dimensional one, it cannot mirror a straight
/// path. The angle is 0 if the positions do not determine it because they are all the same.
Pose2 reference_from_estimate(std::span<const PosePair> pairs, Alignment alignment);

}  // namespace ddtool

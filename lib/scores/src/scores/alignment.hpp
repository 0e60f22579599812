#pragma once

#include <span>
#include <string_view>

#include "scores/association.hpp"

namespace ddtool {

/// Which rigid motion is granted to the estimate before it is compared with the reference.
enum class Alignment {
    none,
    first,  ///< the first poses of both are laid onto each other (evo: --align_origin)
    se2,    ///< least squares over all positions, without scale (Umeyama 1991; evo: --align)
};

/// From "none", "first" or "se2"; throws UsageError otherwise.
Alignment parse_alignment(std::string_view name);

/// The motion that takes the estimate into the reference's frame. There is at least one pair.
/// se2 is Umeyama's solution in two dimensions in closed form: unlike the three-dimensional one it cannot answer a
/// straight path with a reflection. The angle is 0 where the positions leave it open (all in one point).
Pose2 reference_from_estimate(std::span<const PosePair> pairs, Alignment alignment);

}  // namespace ddtool

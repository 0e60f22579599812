#pragma once

#include <cstdint>

namespace ddtool::learning {

/// Second key of a training's random streams, so that one purpose's draws do not shift another's.
enum RandomPurpose : std::uint64_t {
    order_of_samples = 1,  ///< further key: epoch
    augmentation = 2,      ///< further keys: epoch, sample
};

}  // namespace ddtool::learning

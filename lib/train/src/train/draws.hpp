#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "ddtool/base/random.hpp"

namespace ddtool::train {

/// The second key of a training's random streams. It keeps the draws for one purpose independent of the others.
enum RandomPurpose : std::uint64_t {
    order_of_samples = 1,  ///< further key: epoch
    augmentation = 2,      ///< further keys: epoch, sample
};

/// Brings `count` of the values, drawn evenly and without repetition, to the front, in random order (Durstenfeld 1964,
/// algorithm 235). std::shuffle gives other orders with other standard libraries.
template <typename Value>
void shuffle_front(std::vector<Value>& values, std::size_t count, RandomStream& random) {
    for (std::size_t place = 0; place < std::min(count, values.size()); ++place) {
        std::swap(values[place], values[place + random.index(values.size() - place)]);
    }
}

}  // namespace ddtool::train

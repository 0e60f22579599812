#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "network/dd_tables.hpp"

namespace ddtool::network {

/// A square map in memory: row by row, with the channels of a place together, and around it a border one place wide
/// that stays 0 (the padding of a 3x3 convolution).
struct MapShape {
    std::size_t side = 0;
    std::size_t channels = 0;

    [[nodiscard]] std::size_t row_step() const { return (side + 2) * channels; }
    [[nodiscard]] std::size_t size() const { return (side + 2) * row_step(); }
    [[nodiscard]] std::size_t at(std::size_t y, std::size_t x) const {
        return (y + 1) * row_step() + (x + 1) * channels;
    }
};

/// Side of the map that a padded convolution or pooling makes from a map of that side.
inline std::size_t strided(std::size_t side, std::size_t stride) {
    return static_cast<std::size_t>(strided(static_cast<std::int64_t>(side), static_cast<std::int64_t>(stride)));
}

/// Offsets of every stride-th place along each axis, row by row.
inline std::vector<std::size_t> places(const MapShape& shape, std::size_t stride = 1) {
    std::vector<std::size_t> found;
    for (std::size_t y = 0; y < shape.side; y += stride) {
        for (std::size_t x = 0; x < shape.side; x += stride) {
            found.push_back(shape.at(y, x));
        }
    }
    return found;
}

}  // namespace ddtool::network

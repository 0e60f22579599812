#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ddtool {

/// A swarm as a square binary picture of one channel.
struct ParticleImage {
    static constexpr std::uint8_t empty = 0;
    static constexpr std::uint8_t marked = 255;

    std::size_t size_px = 0;
    std::vector<std::uint8_t> pixels;  ///< size_px * size_px, row by row from the top: empty or marked

    bool operator==(const ParticleImage&) const = default;
};

}  // namespace ddtool

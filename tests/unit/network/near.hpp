#pragma once

#include <gmock/gmock.h>

#include <cstddef>
#include <vector>

#include "ddtool/base/random.hpp"
#include "naive_layers.hpp"
#include "network/map_shape.hpp"

namespace ddtool::network {

inline std::vector<float> drawn_floats(std::size_t count, std::uint64_t seed) {
    RandomStream random({seed});
    std::vector<float> values(count);
    for (float& value : values) {
        value = static_cast<float>(random.normal());
    }
    return values;
}

inline naive::Values doubles(const std::vector<float>& values) { return {values.begin(), values.end()}; }

inline void expect_near(const float* actual, const naive::Values& expected, double tolerance) {
    double worst = 0.0;
    for (std::size_t index = 0; index < expected.size(); ++index) {
        worst = std::max(worst, std::abs(static_cast<double>(actual[index]) - expected[index]));
    }
    EXPECT_LE(worst, tolerance);
    EXPECT_FALSE(expected.empty());
}

/// The places of a map in memory, in the order of naive::Map.
inline std::vector<float> planar(const float* map, const MapShape& shape) {
    std::vector<float> values;
    for (std::size_t channel = 0; channel < shape.channels; ++channel) {
        for (const std::size_t place : places(shape)) {
            values.push_back(map[place + channel]);
        }
    }
    return values;
}

/// The reverse: a map with its border in memory.
inline std::vector<float> bordered(const naive::Map& map) {
    const MapShape shape{map.side, map.channels};
    std::vector<float> values(shape.size());
    std::size_t index = 0;
    for (std::size_t channel = 0; channel < shape.channels; ++channel) {
        for (const std::size_t place : places(shape)) {
            values[place + channel] = static_cast<float>(map.values[index++]);
        }
    }
    return values;
}

}  // namespace ddtool::network

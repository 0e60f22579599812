#include "network/softmax.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

#include "base/lanes.hpp"

namespace ddtool::network {
namespace {

using IntegerLanes = std::int32_t __attribute__((vector_size(sizeof(Lanes))));

/// Replaces x by exp(x) for x <= 0, with a relative error of at most 3e-7. std::exp is not used, because its last bit
/// depends on the processor. With x = n ln 2 + r and |r| <= ln(2) / 2, exp(x) is 2^n times the Taylor series of exp(r).
/// Values below -80 are treated as -80: in a sum that is at least 1 such a term does not matter, and smaller ones would
/// be denormal numbers, which are slow.
inline __attribute__((always_inline)) void exponential(Lanes& x) {
    const Lanes least = Lanes{} - 80.0F;
    x = x > least ? x : least;
    // 1.5 * 2^23; adding it to a float and subtracting it again rounds the float to a whole number
    constexpr float to_integer = 12582912.0F;
    const Lanes n = (x * 1.44269504F + to_integer) - to_integer;
    // ln 2 is split into two parts, so that n times the first part is exact
    const Lanes r = (x - n * 0.693359375F) + n * 2.12194440e-4F;
    Lanes series = Lanes{} + 1.0F / 5040.0F;
    for (const float coefficient : {1.0F / 720.0F, 1.0F / 120.0F, 1.0F / 24.0F, 1.0F / 6.0F, 0.5F, 1.0F, 1.0F}) {
        series = series * r + coefficient;
    }
    constexpr std::int32_t exponent_bias = 127;
    constexpr std::int32_t mantissa_bits = 23;
    const IntegerLanes bits = (__builtin_convertvector(n, IntegerLanes) + exponent_bias) << mantissa_bits;
    Lanes power;
    std::memcpy(&power, &bits, sizeof power);
    x = series * power;
}

inline __attribute__((always_inline)) float largest(const float* row, std::size_t count) {
    Lanes most;
    load(most, row);
    for (std::size_t i = lane_count; i < count; i += lane_count) {
        Lanes value;
        load(value, row + i);
        most = value > most ? value : most;
    }
    float result = most[0];
    for (std::size_t lane = 1; lane < lane_count; ++lane) {
        result = std::max(result, most[lane]);
    }
    return result;
}

DDTOOL_VECTORISED void apply_to_row(float* row, std::size_t count, float scale) {
    const float most = largest(row, count);
    Lanes sum{};
    for (std::size_t i = 0; i < count; i += lane_count) {
        Lanes value;
        load(value, row + i);
        value = (value - most) * scale;
        exponential(value);
        store(row + i, value);
        sum += value;
    }
    const auto total = static_cast<float>(sum_of(sum));
    for (std::size_t i = 0; i < count; i += lane_count) {
        Lanes value;
        load(value, row + i);
        store(row + i, value / total);
    }
}

}  // namespace

void apply_softmax(const ScoreRows& matrix, float scale) {
    for (std::size_t index = 0; index < matrix.rows; ++index) {
        float* const row = matrix.scores + index * matrix.row_step;
        std::fill(row + matrix.columns, row + matrix.row_step, std::numeric_limits<float>::lowest());
        apply_to_row(row, matrix.row_step, scale);
    }
}

}  // namespace ddtool::network

#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace ddtool {

/// Eight floats that are processed together. Sums are kept lane by lane and added up in one fixed order, so that a
/// result has the same bytes for every vector width of the processor.
inline constexpr std::size_t lane_count = 8;
using Lanes = float __attribute__((vector_size(lane_count * sizeof(float))));
using IntLanes = std::int32_t __attribute__((vector_size(lane_count * sizeof(std::int32_t))));

/// DDTOOL_VECTORISED compiles a function for several vector widths; the best one for the processor is chosen when the
/// program starts. DDTOOL_VECTORISED_WIDE is for functions whose vectors are twice as wide as Lanes, which are fast
/// only with AVX-512.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_ADDRESS__)
#define DDTOOL_VECTORISED __attribute__((target_clones("arch=x86-64-v3", "default")))
#define DDTOOL_VECTORISED_WIDE __attribute__((target_clones("arch=x86-64-v4", "default")))
/// Whether the processor has everything that x86-64-v4 requires. Each feature is named because Clang 14 does not know
/// the level by its name.
inline bool has_wide_registers() {
    return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
           __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl");
}
#else
#define DDTOOL_VECTORISED
#define DDTOOL_VECTORISED_WIDE
inline bool has_wide_registers() { return false; }
#endif

inline std::size_t round_up_to_lanes(std::size_t count) { return (count + lane_count - 1) / lane_count * lane_count; }

template <typename Vector, typename Element>
inline __attribute__((always_inline)) void load(Vector& lanes, const Element* from) {
    std::memcpy(&lanes, from, sizeof lanes);
}

template <typename Vector, typename Element>
inline __attribute__((always_inline)) void store(Element* to, const Vector& lanes) {
    std::memcpy(to, &lanes, sizeof lanes);
}

inline double sum_of(const Lanes& lanes) {
    double sum = 0.0;
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        sum += static_cast<double>(lanes[lane]);
    }
    return sum;
}

}  // namespace ddtool

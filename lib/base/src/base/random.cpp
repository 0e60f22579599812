#include "ddtool/base/random.hpp"

#include <cmath>
#include <numbers>

namespace ddtool {
namespace {

/// The output function of SplitMix64 (Stafford's variant 13 of the finaliser of MurmurHash3).
std::uint64_t mix(std::uint64_t z) {
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31U);
}

/// The increment of SplitMix64: 2^64 divided by the golden ratio, as an odd number.
constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15ULL;

}  // namespace

RandomStream::RandomStream(std::initializer_list<std::uint64_t> keys) {
    for (const std::uint64_t key : keys) {
        state_ = mix((state_ ^ mix(key + golden_gamma)) + golden_gamma);
    }
}

RandomStream::result_type RandomStream::operator()() {
    state_ += golden_gamma;
    return mix(state_);
}

/// Uses the upper 53 bits, which is the precision of a double.
double RandomStream::uniform() { return static_cast<double>((*this)() >> 11U) * 0x1.0p-53; }

std::uint64_t RandomStream::index(std::uint64_t count) {
    return static_cast<std::uint64_t>(uniform() * static_cast<double>(count));
}

double RandomStream::normal() {
    // 1 - uniform() lies in (0, 1], so the logarithm is finite.
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

}  // namespace ddtool

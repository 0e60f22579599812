#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>

namespace ddtool {

/// SplitMix64 (Steele, Lea, Flood 2014, "Fast splittable pseudorandom number generators"): eight bytes of state, so a
/// stream for every (seed, step, particle) costs nothing and results do not depend on the number of threads.
/// Satisfies UniformRandomBitGenerator; distributions are here too, since the standard's differ between libraries.
class RandomStream {
public:
    using result_type = std::uint64_t;

    /// The stream that is named by the keys in their order, e.g. {seed, step, particle}.
    RandomStream(std::initializer_list<std::uint64_t> keys);

    static constexpr result_type min() { return 0; }
    static constexpr result_type max() { return std::numeric_limits<result_type>::max(); }
    result_type operator()();

    /// Uniform in [0, 1).
    double uniform();
    double uniform(double low, double high) { return low + (high - low) * uniform(); }
    /// Uniform in 0..count-1; count > 0.
    std::uint64_t index(std::uint64_t count);
    /// A standard normal number (Box-Muller). Each call draws two uniform numbers and keeps none for the next call, so
    /// that the state of a stream depends only on the number of calls.
    double normal();

private:
    std::uint64_t state_ = 0;
};

}  // namespace ddtool

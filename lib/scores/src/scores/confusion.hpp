#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ddtool {

/// Counts of decisions compared with the truth. A share is NaN if its denominator is zero.
struct Confusion {
    std::uint64_t true_positives = 0;
    std::uint64_t false_positives = 0;
    std::uint64_t false_negatives = 0;
    std::uint64_t true_negatives = 0;

    void add(bool decided, bool positive);
    [[nodiscard]] std::uint64_t count() const;
    /// The share of all decisions that are right.
    [[nodiscard]] double accuracy() const;
    /// The share of those decided positive that are positive.
    [[nodiscard]] double precision() const;
    /// The share of the positives that were decided positive.
    [[nodiscard]] double recall() const;
    /// Harmonic mean of precision and recall: 2 tp / (2 tp + fp + fn).
    [[nodiscard]] double f1() const;
    bool operator==(const Confusion&) const = default;
};

/// Decides positive if the score is above the threshold; a NaN score is therefore decided negative. Both spans must
/// have the same length.
Confusion confusion_of(std::span<const double> scores, const std::vector<bool>& positive, double threshold);

}  // namespace ddtool

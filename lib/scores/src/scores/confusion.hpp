#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ddtool {

/// Decisions against the truth, counted. A share is NaN where its denominator is zero.
struct Confusion {
    std::uint64_t true_positives = 0;
    std::uint64_t false_positives = 0;
    std::uint64_t false_negatives = 0;
    std::uint64_t true_negatives = 0;

    void add(bool decided, bool positive);
    [[nodiscard]] std::uint64_t count() const;
    /// Share of the decisions that are right.
    [[nodiscard]] double accuracy() const;
    /// Share of those decided positive that are.
    [[nodiscard]] double precision() const;
    /// Share of the positives that are decided so.
    [[nodiscard]] double recall() const;
    /// Harmonic mean of precision and recall: 2 tp / (2 tp + fp + fn).
    [[nodiscard]] double f1() const;
    bool operator==(const Confusion&) const = default;
};

/// Decides positive where the score is above the threshold, so a NaN score is decided negative. Both spans have the
/// same length.
Confusion confusion_of(std::span<const double> scores, const std::vector<bool>& positive, double threshold);

}  // namespace ddtool

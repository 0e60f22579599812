#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <vector>

#include "dataset/build_settings.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// A sample before it is stored.
struct Sample {
    SampleRecord record;
    std::vector<SnapshotParticle> particles;
};

/// Keeps a random choice of the snapshots of a run: one of `every` consecutive ones, and of these at most
/// `most_per_run`, each with the same probability. It never holds more than that many, however long the run is.
class SnapshotThinning {
public:
    /// The same key makes the same choice.
    SnapshotThinning(const ThinningSettings& settings, std::uint64_t key) : settings_(settings), key_(key) {}

    /// Offers the next snapshot; calls `make` for its sample only if it is kept.
    void offer(const std::function<Sample()>& make);
    [[nodiscard]] std::uint64_t offered() const { return offered_; }
    /// Returns the samples that were kept, in the order in which they were offered.
    [[nodiscard]] std::vector<Sample> take();

private:
    struct Kept {
        std::uint64_t position = 0;
        Sample sample;
    };

    ThinningSettings settings_;
    std::uint64_t key_;
    std::uint64_t offered_ = 0;
    std::map<std::uint64_t, Kept> kept_;  ///< by a random number; the smallest stay
};

}  // namespace ddtool::dataset

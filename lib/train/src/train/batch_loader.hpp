#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "dataset/dataset.hpp"
#include "train/sampler.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train {

/// Images of one batch and their classes.
struct Batch {
    std::size_t size_px = 0;
    std::vector<float> images;          ///< count images of size_px * size_px, 0 or 1, rows from the top
    std::vector<std::int64_t> classes;  ///< 0 not degenerate, 1 degenerate
};

/// Makes the batches of one epoch on a thread of its own, a few ahead, so that rendering runs beside the compute. What
/// is in a batch depends on seed, epoch and sample alone.
class BatchLoader {
public:
    /// From step `first_step` of the epoch on. augmentation: null for none (validation).
    BatchLoader(const dataset::Dataset& data, EpochPlan plan, const TrainSettings& settings,
                const AugmentationSettings* augmentation, std::size_t first_step = 0);
    ~BatchLoader();
    BatchLoader(const BatchLoader&) = delete;
    BatchLoader& operator=(const BatchLoader&) = delete;

    /// Gets the next batch; returns false when the epoch is over. Rethrows an exception that was thrown on the thread.
    bool next(Batch& batch);

private:
    class Worker;
    std::unique_ptr<Worker> worker_;
};

}  // namespace ddtool::train

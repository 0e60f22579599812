#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "dataset/dataset.hpp"
#include "train/sampler.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train {

/// The images of one batch and their classes.
struct Batch {
    std::size_t size_px = 0;
    std::vector<float> images;          ///< count images of size_px * size_px, 0 or 1, rows from the top
    std::vector<std::int64_t> classes;  ///< 0 not degenerate, 1 degenerate
};

/// Makes the batches of one epoch on a thread of its own, a few batches ahead, so that images are rendered while the
/// network computes. The content of a batch depends only on the seed, the epoch and the samples.
class BatchLoader {
public:
    /// Begins at step `first_step` of the epoch. augmentation: null for none, as in validation.
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

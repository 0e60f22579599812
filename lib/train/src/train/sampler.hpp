#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ddtool::train {

/// The number of this process in a distributed training, and the number of all processes.
struct Rank {
    std::size_t rank = 0;
    std::size_t world_size = 1;
};

/// The samples that one rank sees in one epoch, batch after batch.
struct EpochPlan {
    std::uint64_t seed = 0;  ///< decides the order of the samples and the augmentation
    std::uint64_t epoch = 0;
    std::vector<std::vector<std::size_t>> batches;  ///< positions in the data set
};

/// A training epoch: the samples in an order drawn from (seed, epoch), divided into global batches of batch_size *
/// world_size samples. Each rank takes its part of each global batch, so two ranks see the same as one rank with the
/// doubled batch size. Samples that do not fill the last global batch are left out. If there are too few samples for
/// one global batch, it consists of all of them, divided as evenly as possible. Throws UsageError if a rank would get
/// no sample.
EpochPlan training_epoch(const std::vector<std::size_t>& samples, std::size_t batch_size, const Rank& rank,
                         std::uint64_t seed, std::uint64_t epoch);

/// All samples in order. The last batch may be smaller.
EpochPlan evaluation_pass(const std::vector<std::size_t>& samples, std::size_t batch_size);

}  // namespace ddtool::train

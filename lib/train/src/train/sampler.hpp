#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ddtool::train {

/// Which process of a distributed training this is.
struct Rank {
    std::size_t rank = 0;
    std::size_t world_size = 1;
};

/// The samples that one rank sees in one epoch, batch after batch.
struct EpochPlan {
    std::uint64_t seed = 0;  ///< of order and augmentation
    std::uint64_t epoch = 0;
    std::vector<std::vector<std::size_t>> batches;  ///< positions in the data set
};

/// A training epoch: the samples in an order drawn from (seed, epoch), cut into global batches of
/// batch_size * world_size, of which each rank takes its piece in order; so two ranks see what one rank with the
/// doubled batch sees. Samples that do not fill the last global batch are left out; if there are too few for one, it is
/// made of them all, as even as can be (every rank has a sample, or UsageError).
EpochPlan training_epoch(const std::vector<std::size_t>& samples, std::size_t batch_size, const Rank& rank,
                         std::uint64_t seed, std::uint64_t epoch);

/// All samples in order, the last batch perhaps smaller.
EpochPlan evaluation_pass(const std::vector<std::size_t>& samples, std::size_t batch_size);

}  // namespace ddtool::train

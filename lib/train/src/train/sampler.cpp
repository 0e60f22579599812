#include "train/sampler.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "ddtool/base/error.hpp"
#include "train/draws.hpp"

namespace ddtool::train {
namespace {

/// The part of a global batch that belongs to a rank. The parts lie in the order of the ranks, and their sizes differ
/// by at most one sample.
std::vector<std::size_t> piece_of(std::span<const std::size_t> global_batch, const Rank& rank) {
    const std::size_t first = global_batch.size() * rank.rank / rank.world_size;
    const std::size_t end = global_batch.size() * (rank.rank + 1) / rank.world_size;
    return {global_batch.begin() + static_cast<std::ptrdiff_t>(first),
            global_batch.begin() + static_cast<std::ptrdiff_t>(end)};
}

}  // namespace

EpochPlan training_epoch(const std::vector<std::size_t>& samples, std::size_t batch_size, const Rank& rank,
                         std::uint64_t seed, std::uint64_t epoch) {
    if (samples.size() < rank.world_size) {
        throw UsageError("training: " + std::to_string(samples.size()) + " samples, expected one or more for each of " +
                         std::to_string(rank.world_size) + " ranks");
    }
    std::vector<std::size_t> order = samples;
    RandomStream random({seed, order_of_samples, epoch});
    shuffle_front(order, order.size(), random);

    const std::size_t global_size = std::min(batch_size * rank.world_size, order.size());
    EpochPlan plan{seed, epoch, {}};
    for (std::size_t first = 0; first + global_size <= order.size(); first += global_size) {
        plan.batches.push_back(piece_of(std::span(order).subspan(first, global_size), rank));
    }
    return plan;
}

EpochPlan evaluation_pass(const std::vector<std::size_t>& samples, std::size_t batch_size) {
    EpochPlan plan;
    for (std::size_t first = 0; first < samples.size(); first += batch_size) {
        const auto batch = std::span(samples).subspan(first, std::min(batch_size, samples.size() - first));
        plan.batches.emplace_back(batch.begin(), batch.end());
    }
    return plan;
}

}  // namespace ddtool::train

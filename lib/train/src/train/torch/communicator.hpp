#pragma once

#include <torch/torch.h>

#include <memory>
#include <optional>
#include <vector>

#include "train/process_group.hpp"
#include "train/sampler.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

/// The processes of one training and what they tell each other, over LibTorch's c10d: Gloo on the CPU, NCCL on CUDA
/// where LibTorch has it. Alone, everything is a no-op. Every member throws Error when another rank was lost;
/// of NCCL, LibTorch's own watchdog ends the process instead.
class Communicator {
public:
    /// Meets the others at the master's address; alone without a process group.
    Communicator(const std::optional<train::ProcessGroup>& group, torch::Device device);
    ~Communicator();
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;

    [[nodiscard]] train::Rank rank() const { return rank_; }
    /// Whether this is rank 0, which alone writes files and messages.
    [[nodiscard]] bool leads() const { return rank_.rank == 0; }

    /// Everyone gets rank 0's values.
    void copy_from_leader(std::vector<torch::Tensor> tensors) const;
    /// Replaces the gradients by their mean over all ranks.
    void average_gradients(const std::vector<torch::Tensor>& parameters) const;
    /// Sums numbers over the ranks.
    [[nodiscard]] std::vector<double> sums(const std::vector<double>& values) const;
    /// Rank 0's numbers.
    [[nodiscard]] std::vector<double> of_leader(const std::vector<double>& values) const;
    /// Makes batch normalisation see the batches of all ranks as one.
    void join_statistics(Network& network) const;

private:
    class Group;
    void add_up(torch::Tensor& tensor) const;

    train::Rank rank_;
    torch::Device device_;
    std::shared_ptr<Group> group_;  ///< null: alone
};

}  // namespace ddtool::train_torch

#pragma once

#include <torch/torch.h>

#include <memory>
#include <optional>
#include <vector>

#include "train/process_group.hpp"
#include "train/sampler.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

/// The communication between the processes of one training, over LibTorch's c10d: Gloo on the CPU, and NCCL on CUDA if
/// LibTorch has it. In a training with a single process nothing is sent. Every member throws Error when another rank is
/// lost; with NCCL, LibTorch's own watchdog ends the process instead.
class Communicator {
public:
    /// Connects to the other ranks at the master's address, or to none without a process group.
    Communicator(const std::optional<train::ProcessGroup>& group, torch::Device device);
    ~Communicator();
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;

    [[nodiscard]] train::Rank rank() const { return rank_; }
    /// Whether this is rank 0, the only one that writes files and messages.
    [[nodiscard]] bool leads() const { return rank_.rank == 0; }

    /// Sets the values of all ranks to those of rank 0.
    void copy_from_leader(std::vector<torch::Tensor> tensors) const;
    /// Replaces the gradients by their mean over all ranks.
    void average_gradients(const std::vector<torch::Tensor>& parameters) const;
    /// The sums of the numbers over the ranks.
    [[nodiscard]] std::vector<double> sums(const std::vector<double>& values) const;
    /// The numbers of rank 0.
    [[nodiscard]] std::vector<double> of_leader(const std::vector<double>& values) const;
    /// Makes batch normalisation treat the batches of all ranks as one.
    void join_statistics(Network& network) const;

private:
    class Group;
    void add_up(torch::Tensor& tensor) const;

    train::Rank rank_;
    torch::Device device_;
    std::shared_ptr<Group> group_;  ///< null in a training with a single process
};

}  // namespace ddtool::train_torch

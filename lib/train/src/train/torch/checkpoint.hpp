#pragma once

#include <torch/torch.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/network/model_description.hpp"
#include "train/torch/network.hpp"
#include "train/training_state.hpp"

namespace ddtool::train_torch {

/// Writes network and description, and with `state` and `optimizer` all that going on needs (weights, optimiser,
/// random state, place in the data), as LibTorch's archive. The old file stays until the new one is whole. Throws Error
/// naming the file.
void write_checkpoint(const std::filesystem::path& path, const Network& network, const ModelDescription& description);
void write_checkpoint(const std::filesystem::path& path, const Network& network, const ModelDescription& description,
                      const torch::optim::Optimizer& optimizer, const train::TrainingState& state);

/// A checkpoint that was opened. Every member throws Error naming the file where it is damaged.
class Checkpoint {
public:
    /// Its tensors go to the device, and so does what is restored from it.
    explicit Checkpoint(const std::filesystem::path& path, torch::Device device = torch::kCPU);

    [[nodiscard]] ModelDescription description();
    /// The network in float32.
    [[nodiscard]] std::shared_ptr<Network> network();
    /// Where the training stood. Throws Error for a checkpoint without it, such as the best one.
    [[nodiscard]] train::TrainingState state();
    /// Restores the weights, the optimiser and LibTorch's random state.
    void restore(Network& network, torch::optim::Optimizer& optimizer);

private:
    [[nodiscard]] std::string text(const char* key);
    template <typename Action>
    auto guarded(Action&& action);

    std::filesystem::path path_;
    torch::serialize::InputArchive archive_;
};

}  // namespace ddtool::train_torch

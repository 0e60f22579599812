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

/// Writes the network and its description as an archive of LibTorch. With `state` and `optimizer` it also writes all
/// that is needed to resume the training (weights, optimiser, random state, position in the data). An older file stays
/// until the new one is complete. Throws Error naming the file.
void write_checkpoint(const std::filesystem::path& path, const Network& network, const ModelDescription& description);
void write_checkpoint(const std::filesystem::path& path, const Network& network, const ModelDescription& description,
                      const torch::optim::Optimizer& optimizer, const train::TrainingState& state);

/// A checkpoint that was opened. Every member throws Error naming the file if it is damaged.
class Checkpoint {
public:
    /// The tensors are loaded to the device, and what is restored from them stays there.
    explicit Checkpoint(const std::filesystem::path& path, torch::Device device = torch::kCPU);

    [[nodiscard]] ModelDescription description();
    /// The network in float32.
    [[nodiscard]] std::shared_ptr<Network> network();
    /// The state of the training. Throws Error if the checkpoint has none, as that of the best network.
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

#pragma once

#include <filesystem>
#include <memory>

#include "ddtool/network/model_description.hpp"
#include "network/safetensors.hpp"
#include "train/engine.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

/// Writes the network as TorchScript that owns its parameters: images [n, 1, size_px, size_px] to the two values of
/// output_values(), for any n. The description travels inside as the extra file ddtool.json. The network is put into
/// its evaluation mode.
void write_torch_script(const std::filesystem::path& path, Network& network, const ModelDescription& description);

/// Whether the file holds what write_torch_script() writes, rather than a checkpoint. Throws Error where it can be
/// neither.
bool is_exported_model(const std::filesystem::path& path);

/// A model that write_torch_script() wrote. Throws Error naming the file for one that is damaged, not of ddtool,
/// or listed otherwise in a SHA256SUMS beside it.
/// TorchScript is a program: load only files you trust.
std::unique_ptr<DegreeModel> load_torch_script(const std::filesystem::path& path, const train::RunOptions& options);

/// The tensors of a network under their dotted names, batch statistics among them.
network::PlainWeights plain_weights(const Network& network, const ModelDescription& about);

}  // namespace ddtool::train_torch

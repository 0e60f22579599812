#pragma once

#include <filesystem>
#include <memory>

#include "ddtool/network/model_description.hpp"
#include "network/safetensors.hpp"
#include "train/engine.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

/// Writes the network as TorchScript with its own parameters. It maps images [n, 1, size_px, size_px] to the two values
/// of output_values(), for any n. The description is stored inside as the extra file ddtool.json. Puts the network into
/// evaluation mode.
void write_torch_script(const std::filesystem::path& path, Network& network, const ModelDescription& description);

/// Whether the file was written by write_torch_script() and is not a checkpoint. Throws Error if it is neither.
bool is_exported_model(const std::filesystem::path& path);

/// The description in a model that write_torch_script() wrote. Throws Error naming the file.
ModelDescription description_of_torch_script(const std::filesystem::path& path);

/// Loads a model that write_torch_script() wrote. Throws Error naming the file if it is damaged, is not a model of
/// ddtool, or has another checksum in a SHA256SUMS in its folder. TorchScript is a program, so load only files that you
/// trust.
std::unique_ptr<DegreeModel> load_torch_script(const std::filesystem::path& path, const train::RunOptions& options);

/// The tensors of a network, including the batch statistics, by their dotted names.
network::PlainWeights plain_weights(const Network& network, const ModelDescription& about);

}  // namespace ddtool::train_torch

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "ddtool/network/degree_model.hpp"

namespace ddtool {

/// Loads a network of the DD-Model's kind from its plain weights (docs/formats/model.md). It runs on one core without
/// LibTorch, and its logits are the same, byte for byte, on every processor. Throws Error naming the file, and the
/// tensor if one is missing or its shape differs from the network's table. Also throws Error if a SHA256SUMS beside the
/// file lists another checksum for it.
std::unique_ptr<DegreeModel> load_model(const std::filesystem::path& path);
/// The same for a file's content; `name` is used in error messages.
std::unique_ptr<DegreeModel> load_model(std::string_view bytes, const std::string& name);

}  // namespace ddtool

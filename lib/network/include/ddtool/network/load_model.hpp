#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "ddtool/network/degree_model.hpp"

namespace ddtool::native {

/// A network of the DD-Model's kind from its plain weights (docs/formats/model.md), run on one core without LibTorch.
/// The logits are the same bytes on every processor. Throws Error naming the file, and the tensor where
/// one is missing or has another shape than the network's table says; and for a file that a SHA256SUMS beside it lists
/// otherwise.
std::unique_ptr<DegreeModel> load_model(const std::filesystem::path& path);
/// The same of a file's content; `name` is for errors.
std::unique_ptr<DegreeModel> load_model(std::string_view bytes, const std::string& name);

}  // namespace ddtool::native

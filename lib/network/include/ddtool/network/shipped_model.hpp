#pragma once

#include <memory>
#include <string>

#include "ddtool/network/degree_model.hpp"

namespace ddtool {

/// The name of the network that is embedded in every program of the project (data/models/ddmodel-lite.safetensors), so
/// that the filter needs no separate model file.
inline constexpr const char* shipped_model_name = "ddmodel-lite";

/// A new instance of that network.
std::unique_ptr<DegreeModel> shipped_model();

/// Fingerprint of its bytes.
std::string shipped_model_fingerprint();

}  // namespace ddtool

#pragma once

#include <memory>
#include <string>

#include "ddtool/network/degree_model.hpp"

namespace ddtool::native {

/// The name of the network that every program of ours carries inside: data/models/ddmodel-lite.safetensors, so that
/// the filter needs no file beside it.
inline constexpr const char* shipped_model_name = "ddmodel-lite";

std::unique_ptr<DegreeModel> shipped_model();

/// Of its bytes.
std::string shipped_model_fingerprint();

}  // namespace ddtool::native

#pragma once

#include <memory>
#include <string>

#include "ddtool/network/degree_model.hpp"

namespace ddtool {

/// The names of the networks that are embedded in every program of the project (data/models/NAME.safetensors), so that
/// the filter needs no separate model file: the one of the default method, and the one that was trained on the paper's
/// pairing of label and image, for the method paper.
inline constexpr const char* shipped_model_name = "ddmodel-lite";
inline constexpr const char* paper_model_name = "ddmodel-paper";

/// Whether a network of that name is embedded.
bool is_shipped(const std::string& name);

/// A new instance of that network. Throws std::out_of_range if none of that name is embedded.
std::unique_ptr<DegreeModel> shipped_model(const std::string& name = shipped_model_name);

/// How the detector of that name sees a swarm. For an embedded network and one in a .safetensors file these are the
/// settings of its images; for anything else those of the default method's network. Throws Error as load_model() does.
ImageSettings image_seen_natively(const std::string& detector);

/// Fingerprint of its bytes. Throws std::out_of_range as above.
std::string shipped_model_fingerprint(const std::string& name = shipped_model_name);

}  // namespace ddtool

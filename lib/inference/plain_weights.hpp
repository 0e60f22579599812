#pragma once

#include "models/network.hpp"
#include "native/model_description.hpp"
#include "native/safetensors.hpp"

namespace ddtool::inference {

/// The tensors of a network under their dotted names, batch statistics among them.
native::PlainWeights plain_weights(const models::Network& network, const native::ModelDescription& about);

}  // namespace ddtool::inference

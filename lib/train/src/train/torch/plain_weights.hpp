#pragma once

#include "ddtool/network/model_description.hpp"
#include "network/safetensors.hpp"
#include "train/torch/network.hpp"

namespace ddtool::inference {

/// The tensors of a network under their dotted names, batch statistics among them.
native::PlainWeights plain_weights(const models::Network& network, const native::ModelDescription& about);

}  // namespace ddtool::inference

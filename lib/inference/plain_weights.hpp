#pragma once

#include "learning/model_description.hpp"
#include "learning/safetensors.hpp"
#include "models/network.hpp"

namespace ddtool::inference {

/// The tensors of a network under their dotted names, batch statistics among them.
learning::PlainWeights plain_weights(const models::Network& network, const learning::ModelDescription& about);

}  // namespace ddtool::inference

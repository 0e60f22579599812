#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "ddtool/network/image_settings.hpp"
#include "ddtool/system/json_struct.hpp"

namespace ddtool::native {

/// What must be known to use a trained network, and where it comes from. It travels inside checkpoints and exported
/// models as JSON.
struct ModelDescription {
    std::string network;             ///< row of the table of networks
    std::string loss;                ///< cross-entropy: the two values sum to one (softmax); bce: each by itself
    ImageSettings image;             ///< images of any other kind are not what it knows
    std::string label = "fisher";    ///< dataset::label_rule_names
    std::string split = "held_out";  ///< dataset::split_names: whose part train it saw
    std::string dataset;             ///< fingerprint of the data set's manifest
    std::uint64_t seed = 0;
    double temperature = 1.0;  ///< the logits are divided by it, so that the degree is a probability
    Json metrics;              ///< on the part validation, of the epoch that was kept
};
DDTOOL_JSON_STRUCT(ModelDescription, network, loss, image, label, split, dataset, seed, temperature, metrics)

/// The description that travels as this text. Throws Error naming the file for another text, and for values that no
/// network can have.
ModelDescription parse_description(const std::string& text, const std::string& file);

/// The two classes in the order of the network's outputs.
inline constexpr std::size_t degenerate_output = 1;

}  // namespace ddtool::native

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "ddtool/network/image_settings.hpp"
#include "ddtool/system/json_struct.hpp"

namespace ddtool {

/// What must be known to use a trained network, and its origin. It is stored as JSON inside checkpoints and exported
/// models.
struct ModelDescription {
    std::string network;             ///< row of the table of networks
    std::string loss;                ///< cross-entropy: the two values sum to one (softmax); bce: each is independent
    ImageSettings image;             ///< how the images it was trained on are made
    std::string label = "fisher";    ///< one of dataset::label_rule_names
    std::string split = "held_out";  ///< one of dataset::split_names; it was trained on the part train
    std::string dataset;             ///< fingerprint of the data set's manifest
    std::uint64_t seed = 0;
    double temperature = 1.0;  ///< the logits are divided by it, so that the degree is a probability
    Json metrics;              ///< of the epoch that was kept, on the part validation
};
DDTOOL_JSON_STRUCT(ModelDescription, network, loss, image, label, split, dataset, seed, temperature, metrics)

/// Reads the description from its JSON text. Throws Error naming the file if the text is not such JSON or has values
/// that no network can have.
ModelDescription parse_model_description(const std::string& text, const std::string& file);

/// Index of the class "degenerate" among the two outputs of the network.
inline constexpr std::size_t degenerate_output = 1;

}  // namespace ddtool

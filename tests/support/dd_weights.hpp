#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "ddtool/base/random.hpp"
#include "ddtool/network/model_description.hpp"
#include "network/dd_tables.hpp"
#include "network/safetensors.hpp"

namespace ddtool::test {

/// Draws the weights of networks, with a standard deviation of 1 / sqrt(fan-in), so that values neither vanish nor grow
/// from layer to layer.
class DrawnWeights {
public:
    explicit DrawnWeights(std::uint64_t seed) : random_({seed}) {}

    void add(const std::string& name, const std::vector<std::int64_t>& shape, double middle, double spread) {
        network::NamedTensor tensor{name, shape, {}};
        std::int64_t count = 1;
        for (const std::int64_t length : shape) {
            count *= length;
        }
        for (std::int64_t index = 0; index < count; ++index) {
            tensor.values.push_back(static_cast<float>(middle + spread * random_.uniform(-1.0, 1.0)));
        }
        tensors.push_back(std::move(tensor));
    }
    void add_convolution(const std::string& prefix, std::int64_t outputs, std::int64_t inputs, std::int64_t kernel_px) {
        const auto fan_in = static_cast<double>(inputs * kernel_px * kernel_px);
        add(prefix + ".conv.weight", {outputs, inputs, kernel_px, kernel_px}, 0.0, 2.0 / std::sqrt(fan_in));
        add(prefix + ".norm.weight", {outputs}, 1.0, 0.5);
        add(prefix + ".norm.bias", {outputs}, 0.0, 0.5);
        add(prefix + ".norm.running_mean", {outputs}, 0.0, 0.5);
        add(prefix + ".norm.running_var", {outputs}, 1.0, 0.5);
    }
    void add_linear(const std::string& prefix, std::int64_t outputs, std::int64_t inputs) {
        add(prefix + ".weight", {outputs, inputs}, 0.0, 2.0 / std::sqrt(static_cast<double>(inputs)));
        add(prefix + ".bias", {outputs}, 0.0, 0.5);
    }
    void add_layer_norm(const std::string& prefix, std::int64_t width) {
        add(prefix + ".weight", {width}, 1.0, 0.5);
        add(prefix + ".bias", {width}, 0.0, 0.5);
    }
    void add_encoder(const network::EncoderRow& row) {
        add_layer_norm("encoder.attention_norm", row.width);
        add_linear("encoder.query_key_value", 3 * row.width, row.width);
        add_linear("encoder.attention_out", row.width, row.width);
        add_layer_norm("encoder.feed_forward_norm", row.width);
        add_linear("encoder.feed_forward_in", row.feed_forward, row.width);
        add_linear("encoder.feed_forward_out", row.width, row.feed_forward);
    }

    std::vector<network::NamedTensor> tensors;

private:
    RandomStream random_;
};

/// All tensors of a network of the DD-Model's kind, drawn at random.
inline std::vector<network::NamedTensor> drawn_dd_weights(const network::DDModelTable& table, std::int64_t size_px) {
    DrawnWeights weights(1);
    weights.add_convolution("stem", table.stem.channels, 1, table.stem.kernel_px);
    std::int64_t channels = table.stem.channels;
    int number = 0;
    for (const network::GroupRow& group : table.groups) {
        for (std::int64_t block = 0; block < group.blocks; ++block) {
            const std::string prefix = "groups." + std::to_string(number++);
            weights.add_convolution(prefix + ".first", group.channels, channels, 3);
            weights.add_convolution(prefix + ".second", group.channels, group.channels, 3);
            if (channels != group.channels || (block == 0 && group.stride != 1)) {
                weights.add_convolution(prefix + ".projection", group.channels, channels, 1);
            }
            channels = group.channels;
        }
    }
    weights.add_linear("embedding", table.encoder.width, channels);
    weights.add("position", {network::token_count(table, size_px), table.encoder.width}, 0.0, 0.5);
    if (table.encoder.has_layer) {
        weights.add_encoder(table.encoder);
    }
    weights.add_layer_norm("norm", table.encoder.width);
    weights.add_linear("head", 2, table.encoder.width);
    return weights.tensors;
}

/// The content of a file that `ddtool export` would write for such a network.
inline network::PlainWeights drawn_dd_model(const std::string& network, std::size_t size_px) {
    ModelDescription about;
    about.network = network;
    about.loss = "cross-entropy";
    about.image.size_px = size_px;
    return {Json(about).dump(),
            drawn_dd_weights(*network::find_ddmodel_table(network), static_cast<std::int64_t>(size_px))};
}

}  // namespace ddtool::test

#include "network/dd_network.hpp"

#include "dd_weights.hpp"
#include "near.hpp"

namespace ddtool::network {
namespace {

naive::Map naive_block(const naive::Tensors& tensors, const std::string& prefix, const naive::Map& in,
                       std::size_t channels, std::size_t stride) {
    const naive::Map first = naive::relu(naive::convolution(tensors, prefix + ".first", in, channels, 3, stride));
    naive::Map out = naive::convolution(tensors, prefix + ".second", first, channels, 3, 1);
    const bool same = in.channels == channels && stride == 1;
    const naive::Map skip = same ? in : naive::convolution(tensors, prefix + ".projection", in, channels, 1, stride);
    out.values = naive::relu(naive::sum(out.values, skip.values));
    return out;
}

naive::Map naive_backbone(const naive::Tensors& tensors, const network::DDModelTable& table, const naive::Map& image) {
    const auto& stem = table.stem;
    naive::Map map = naive::relu(naive::max_pool(
        naive::convolution(tensors, "stem", image, static_cast<std::size_t>(stem.channels),
                           static_cast<std::size_t>(stem.kernel_px), static_cast<std::size_t>(stem.stride))));
    int number = 0;
    for (const network::GroupRow& group : table.groups) {
        for (std::int64_t block = 0; block < group.blocks; ++block) {
            map = naive_block(tensors, "groups." + std::to_string(number++), map,
                              static_cast<std::size_t>(group.channels),
                              static_cast<std::size_t>(block == 0 ? group.stride : 1));
        }
    }
    return map;
}

naive::Values naive_encoder(const naive::Tensors& tensors, const network::EncoderRow& row, const naive::Values& in) {
    const auto width = static_cast<std::size_t>(row.width);
    const auto linear = [&](const std::string& name, const naive::Values& x, std::int64_t inputs) {
        return naive::linear(tensors, "encoder." + name, x, static_cast<std::size_t>(inputs));
    };
    const naive::Values normed = naive::layer_norm(tensors, "encoder.attention_norm", in);
    const naive::Values mixed =
        naive::attention(linear("query_key_value", normed, row.width), width, static_cast<std::size_t>(row.heads));
    const naive::Values attended = naive::sum(in, linear("attention_out", mixed, row.width));
    const naive::Values hidden = naive::relu(
        linear("feed_forward_in", naive::layer_norm(tensors, "encoder.feed_forward_norm", attended), row.width));
    return naive::sum(attended, linear("feed_forward_out", hidden, row.feed_forward));
}

naive::Values naive_logits(const naive::Tensors& tensors, const network::DDModelTable& table, const naive::Map& image) {
    const naive::Map map = naive_backbone(tensors, table, image);
    const std::size_t count = map.side * map.side;
    naive::Values tokens;
    for (std::size_t token = 0; token < count; ++token) {
        for (std::size_t channel = 0; channel < map.channels; ++channel) {
            tokens.push_back(map.values[channel * count + token]);
        }
    }
    const auto width = static_cast<std::size_t>(table.encoder.width);
    tokens = naive::sum(naive::linear(tensors, "embedding", tokens, map.channels), naive::tensor(tensors, "position"));
    tokens = naive::layer_norm(tensors, "norm",
                               table.encoder.has_layer ? naive_encoder(tensors, table.encoder, tokens) : tokens);
    naive::Values mean(width);
    for (std::size_t index = 0; index < tokens.size(); ++index) {
        mean[index % width] += tokens[index] / static_cast<double>(count);
    }
    return naive::linear(tensors, "head", mean, width);
}

/// A network with two blocks in a group, a stride that halves an odd side, and more than one head.
network::DDModelTable tiny_table() {
    return {.stem = {.kernel_px = 7, .stride = 2, .channels = 16},
            .groups = {{.blocks = 1, .channels = 16, .stride = 1}, {.blocks = 2, .channels = 32, .stride = 2}},
            .encoder = {.width = 32, .heads = 2, .feed_forward = 48}};
}

void expect_naive_logits(const network::DDModelTable& table, std::size_t size_px) {
    const naive::Tensors tensors = test::drawn_dd_weights(table, static_cast<std::int64_t>(size_px));
    NamedWeights weights(tensors);
    DDNetwork network(weights, table, size_px);
    weights.expect_all_taken();
    RandomStream random({14});
    for (const double share : {0.0, 0.05, 0.5}) {
        std::vector<float> image(size_px * size_px);
        std::generate(image.begin(), image.end(), [&] { return random.uniform() < share ? 1.0F : 0.0F; });
        const naive::Values expected = naive_logits(tensors, table, {1, size_px, doubles(image)});
        const std::array<double, 2> logits = network.run(image);
        EXPECT_NEAR(logits[0], expected[0], 2e-5) << share;
        EXPECT_NEAR(logits[1], expected[1], 2e-5) << share;
    }
}

TEST(DDNetwork, IsThatOfItsDefinition) {
    expect_naive_logits(tiny_table(), 26);
    expect_naive_logits(network::ddmodel_lite_table(), 64);
    expect_naive_logits(network::ddmodel_table(), 24);
    expect_naive_logits(*network::find_ddmodel_table("ddmodel-lite-deep"), 64);
    expect_naive_logits(*network::find_ddmodel_table("ddmodel-lite-no-transformer"), 64);
}

}  // namespace
}  // namespace ddtool::network

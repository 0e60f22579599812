#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace ddtool::network {

/// First convolution of the backbone. A 3x3 max pooling of stride 2 follows.
struct StemRow {
    std::int64_t kernel_px = 0;
    std::int64_t stride = 0;
    std::int64_t channels = 0;
};

/// One of the backbone's "composite layers": BasicBlocks, the first of which may change the shape.
struct GroupRow {
    std::int64_t blocks = 0;
    std::int64_t channels = 0;
    std::int64_t stride = 0;  ///< of the first block
};

/// The neck: one layer of a transformer encoder, or none, so that the tokens go on as they are.
struct EncoderRow {
    std::int64_t width = 0;         ///< of a token
    std::int64_t heads = 0;         ///< divides the width
    std::int64_t feed_forward = 0;  ///< width of its hidden layer
    bool has_layer = true;          ///< false: tokens do not see each other
};

/// A network of the DD-Model's kind: residual backbone, transformer neck and two-way head (paper, section "Degeneracy
/// Detection Model" and its figure; docs/models.md says what the paper leaves open).
struct DDModelTable {
    StemRow stem;
    std::vector<GroupRow> groups;
    EncoderRow encoder;
};

/// The paper's network. The map that goes to its neck is 256 x 28 x 28 for images of 224 x 224.
const DDModelTable& ddmodel_table();
/// A smaller version of it for a robot's processor.
const DDModelTable& ddmodel_lite_table();
/// A network that can be trained, by its name.
struct NamedDDModel {
    std::string name;
    DDModelTable table;
};
/// Both networks and, for the ablation, each of them with two BasicBlocks in each group ("-deep") and without the
/// transformer ("-no-transformer").
const std::vector<NamedDDModel>& named_ddmodels();
/// The table of one of them; null for another network.
const DDModelTable* find_ddmodel_table(const std::string& network);

/// Side of the map that a padded convolution or pooling with an odd kernel makes from a map of side side_px.
constexpr std::int64_t strided(std::int64_t side_px, std::int64_t stride) { return (side_px - 1) / stride + 1; }
/// Number of places, and so of tokens, of the map that goes to the neck.
std::int64_t token_count(const DDModelTable& table, std::int64_t size_px);

}  // namespace ddtool::network

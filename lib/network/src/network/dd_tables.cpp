#include "network/dd_tables.hpp"

#include <algorithm>

namespace ddtool::network {
namespace {

/// Two BasicBlocks in each group, as in ResNet-18 (He et al. 2016, table 1).
DDModelTable deep(DDModelTable table) {
    for (GroupRow& group : table.groups) {
        group.blocks = 2;
    }
    return table;
}

DDModelTable without_transformer(DDModelTable table) {
    table.encoder.has_layer = false;
    return table;
}

}  // namespace

const DDModelTable& ddmodel_table() {
    static const DDModelTable table{
        .stem = {.kernel_px = 7, .stride = 2, .channels = 32},
        .groups = {{.blocks = 1, .channels = 32, .stride = 1},
                   {.blocks = 1, .channels = 64, .stride = 2},
                   {.blocks = 1, .channels = 128, .stride = 1},
                   {.blocks = 1, .channels = 256, .stride = 1}},
        .encoder = {.width = 64, .heads = 1, .feed_forward = 128},
    };
    return table;
}

const DDModelTable& ddmodel_lite_table() {
    static const DDModelTable table{
        .stem = {.kernel_px = 7, .stride = 4, .channels = 16},
        .groups = {{.blocks = 1, .channels = 16, .stride = 1},
                   {.blocks = 1, .channels = 32, .stride = 2},
                   {.blocks = 1, .channels = 64, .stride = 2}},
        .encoder = {.width = 64, .heads = 2, .feed_forward = 128},
    };
    return table;
}

const std::vector<NamedDDModel>& named_ddmodels() {
    static const std::vector<NamedDDModel> all{
        {"ddmodel", ddmodel_table()},
        {"ddmodel-lite", ddmodel_lite_table()},
        {"ddmodel-deep", deep(ddmodel_table())},
        {"ddmodel-lite-deep", deep(ddmodel_lite_table())},
        {"ddmodel-no-transformer", without_transformer(ddmodel_table())},
        {"ddmodel-lite-no-transformer", without_transformer(ddmodel_lite_table())},
    };
    return all;
}

const DDModelTable* find_ddmodel_table(const std::string& network) {
    const auto found = std::ranges::find(named_ddmodels(), network, &NamedDDModel::name);
    return found == named_ddmodels().end() ? nullptr : &found->table;
}

std::int64_t token_count(const DDModelTable& table, std::int64_t size_px) {
    std::int64_t side = strided(strided(size_px, table.stem.stride), 2);
    for (const GroupRow& group : table.groups) {
        side = strided(side, group.stride);
    }
    return side * side;
}

}  // namespace ddtool::network

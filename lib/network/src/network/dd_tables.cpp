#include "network/dd_tables.hpp"

namespace ddtool::network {

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

const DDModelTable* find_ddmodel_table(const std::string& network) {
    if (network == "ddmodel") {
        return &ddmodel_table();
    }
    return network == "ddmodel-lite" ? &ddmodel_lite_table() : nullptr;
}

std::int64_t token_count(const DDModelTable& table, std::int64_t size_px) {
    std::int64_t side = strided(strided(size_px, table.stem.stride), 2);
    for (const GroupRow& group : table.groups) {
        side = strided(side, group.stride);
    }
    return side * side;
}

}  // namespace ddtool::network

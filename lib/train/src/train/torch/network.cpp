#include "train/torch/network.hpp"

#include <algorithm>
#include <array>
#include <functional>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "train/torch/ddmodel.hpp"
#include "train/torch/mobilenetv3.hpp"

namespace ddtool::train_torch {
namespace {

struct NetworkRow {
    std::string name;
    std::function<std::shared_ptr<Network>(std::int64_t size_px)> make;
};

const std::array<NetworkRow, 3>& networks() {
    static const std::array<NetworkRow, 3> table{{
        {"ddmodel", [](std::int64_t size_px) { return std::make_shared<DDModel>(network::ddmodel_table(), size_px); }},
        {"ddmodel-lite",
         [](std::int64_t size_px) { return std::make_shared<DDModel>(network::ddmodel_lite_table(), size_px); }},
        {"mobilenetv3", [](std::int64_t) { return std::make_shared<MobileNetV3>(); }},
    }};
    return table;
}

}  // namespace

std::vector<std::string> network_names() {
    std::vector<std::string> names;
    for (const NetworkRow& row : networks()) {
        names.push_back(row.name);
    }
    return names;
}

std::shared_ptr<Network> make_network(const std::string& name, std::size_t size_px) {
    const auto row = std::ranges::find(networks(), name, &NetworkRow::name);
    if (row == networks().end()) {
        throw UsageError("no network named '" + name + "', only " + joined(network_names()));
    }
    std::shared_ptr<Network> network = row->make(static_cast<std::int64_t>(size_px));
    lay_out_channels_last(*network);
    return network;
}

}  // namespace ddtool::train_torch

#include "train/torch/network.hpp"

#include <algorithm>
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

std::vector<NetworkRow> all_networks() {
    std::vector<NetworkRow> rows;
    for (const network::NamedDDModel& each : network::named_ddmodels()) {
        rows.push_back({each.name, [&table = each.table](std::int64_t size_px) {
                            return std::make_shared<DDModel>(table, size_px);
                        }});
    }
    rows.push_back({"mobilenetv3", [](std::int64_t) { return std::make_shared<MobileNetV3>(); }});
    return rows;
}

const std::vector<NetworkRow>& networks() {
    static const std::vector<NetworkRow> rows = all_networks();
    return rows;
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

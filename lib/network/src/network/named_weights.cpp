#include "network/named_weights.hpp"

#include <algorithm>
#include <utility>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::network {

NamedWeights::NamedWeights(std::vector<NamedTensor> tensors) {
    for (NamedTensor& tensor : tensors) {
        tensors_.insert_or_assign(tensor.name, std::move(tensor));
    }
}

std::vector<float> NamedWeights::take(const std::string& name, const std::vector<std::size_t>& shape) {
    const auto node = tensors_.extract(name);
    if (node.empty()) {
        throw Error("no tensor " + name + ", expected one of shape " + Json(shape).dump());
    }
    if (!std::ranges::equal(node.mapped().shape, shape, std::cmp_equal<std::int64_t, std::size_t>)) {
        throw Error("tensor " + name + " has the shape " + Json(node.mapped().shape).dump() + ", expected " +
                    Json(shape).dump());
    }
    return std::move(node.mapped().values);
}

void NamedWeights::expect_all_taken() const {
    if (!tensors_.empty()) {
        throw Error("tensor " + tensors_.begin()->first + " has no place in the network that the description names");
    }
}

}  // namespace ddtool::network

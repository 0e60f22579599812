#include "train/torch/plain_weights.hpp"

namespace ddtool::inference {

native::PlainWeights plain_weights(const models::Network& network, const native::ModelDescription& about) {
    native::PlainWeights weights{Json(about).dump(), {}};
    const auto add = [&](const auto& items) {
        for (const auto& item : items) {
            const torch::Tensor values = item.value().detach().to(torch::kCPU, torch::kFloat32).contiguous();
            weights.tensors.push_back({item.key(),
                                       values.sizes().vec(),
                                       {values.data_ptr<float>(), values.data_ptr<float>() + values.numel()}});
        }
    };
    add(network.named_parameters());
    add(network.named_buffers());
    return weights;
}

}  // namespace ddtool::inference

#pragma once

#include <torch/torch.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/network/degree_model.hpp"
#include "train/torch/network.hpp"

namespace ddtool::train_torch {

inline constexpr std::int64_t size_px = 64;

inline ModelDescription described(const std::string& network, const std::string& loss) {
    ModelDescription about;
    about.network = network;
    about.loss = loss;
    about.image.size_px = size_px;
    about.temperature = 1.7;
    about.dataset = "0123456789abcdef";
    return about;
}

/// Random sparse images, like particle images. Some have more marks than others.
inline torch::Tensor drawn_images(std::int64_t count) {
    return (torch::rand({count, 1, size_px, size_px}) < 0.3 * torch::rand({count, 1, 1, 1})).to(torch::kFloat32);
}

inline std::vector<double> degrees_by(DegreeModel& model, const torch::Tensor& images) {
    std::vector<double> degrees(static_cast<std::size_t>(images.size(0)));
    model.run({images.data_ptr<float>(), static_cast<std::size_t>(images.numel())}, degrees);
    return degrees;
}

/// Whether the degrees differ from image to image. If they do not, a wrong network would not be noticed by them either.
inline bool differ(const std::vector<double>& degrees) {
    const auto [least, greatest] = std::minmax_element(degrees.begin(), degrees.end());
    return *greatest - *least > 1e-3;
}

/// A network whose running statistics are those of a batch. A single training step would move them only a tenth or a
/// hundredth of the way there, and most layers would then give the same answer for every image.
inline std::shared_ptr<Network> used_network(const std::string& name) {
    torch::manual_seed(7);
    auto network = make_network(name, size_px);
    const torch::NoGradGuard no_gradients;
    network->train();
    (void)network->forward(drawn_images(16));
    network->eval();
    const double step = name == "mobilenetv3" ? 0.01 : 0.1;
    for (auto& buffer : network->named_buffers()) {
        const double before = buffer.key().ends_with("running_var") ? 1.0 : 0.0;
        buffer.value().sub_((1.0 - step) * before).div_(step);
    }
    return network;
}

}  // namespace ddtool::train_torch

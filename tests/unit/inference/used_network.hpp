#pragma once

#include <torch/torch.h>

#include <memory>
#include <string>
#include <vector>

#include "models/network.hpp"
#include "native/degree_model.hpp"

namespace ddtool::inference {

inline constexpr std::int64_t size_px = 64;

inline native::ModelDescription described(const std::string& network, const std::string& loss) {
    native::ModelDescription about;
    about.network = network;
    about.loss = loss;
    about.image.size_px = size_px;
    about.temperature = 1.7;
    about.dataset = "0123456789abcdef";
    return about;
}

/// Sparse, as particle images are.
inline torch::Tensor drawn_images(std::int64_t count) {
    return (torch::rand({count, 1, size_px, size_px}) < 0.1).to(torch::kFloat32);
}

inline std::vector<double> degrees_by(native::DegreeModel& model, const torch::Tensor& images) {
    std::vector<double> degrees(static_cast<std::size_t>(images.size(0)));
    model.run({images.data_ptr<float>(), static_cast<std::size_t>(images.numel())}, degrees);
    return degrees;
}

/// A network whose batch statistics are those of some training.
inline std::shared_ptr<models::Network> used_network(const std::string& name) {
    torch::manual_seed(7);
    auto network = models::make_network(name, size_px);
    network->train();
    for (int step = 0; step < 3; ++step) {
        (void)network->forward(drawn_images(8));
    }
    network->eval();
    return network;
}

}  // namespace ddtool::inference

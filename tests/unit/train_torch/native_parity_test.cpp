#include <gmock/gmock.h>

#include "ddtool/network/load_model.hpp"
#include "temporary_folder.hpp"
#include "train/torch/exported_model.hpp"
#include "train/torch/losses.hpp"
#include "used_network.hpp"

namespace ddtool::train_torch {
namespace {

/// Images without marks, with few, with many, with all pixels marked, and with one blob in a corner.
torch::Tensor images_of_all_kinds() {
    torch::Tensor images = torch::zeros({5, 1, size_px, size_px});
    images[1] = drawn_images(1)[0];
    images[2] = (torch::rand({1, size_px, size_px}) < 0.5).to(torch::kFloat32);
    images[3].fill_(1.0);
    images[4][0].slice(0, 0, 9).slice(1, size_px - 7, size_px).fill_(1.0);
    return images;
}

class NativeModel : public testing::TestWithParam<std::string> {};

TEST_P(NativeModel, AgreesWithTheNetworkInLibTorch) {
    const std::shared_ptr<Network> network = used_network(GetParam());
    const torch::Tensor images = images_of_all_kinds();
    const test::TemporaryFolder folder;
    for (const char* loss : {"cross-entropy", "bce"}) {
        const ModelDescription about = described(GetParam(), loss);
        network::write_safetensors(folder / "model.safetensors", plain_weights(*network, about));
        const std::vector<double> degrees = degrees_by(*load_model(folder / "model.safetensors"), images);
        const torch::NoGradGuard no_gradients;
        const torch::Tensor expected =
            output_values(loss, network->forward(images) / about.temperature).select(1, degenerate_output);
        for (std::size_t index = 0; index < degrees.size(); ++index) {
            EXPECT_NEAR(degrees[index], expected[static_cast<std::int64_t>(index)].item<double>(), 1e-5)
                << loss << ", image " << index;
        }
        EXPECT_GT(std::abs(degrees[0] - degrees[3]), 1e-3) << "too alike to tell a wrong network by";
    }
}

INSTANTIATE_TEST_SUITE_P(Networks, NativeModel,
                         testing::Values("ddmodel", "ddmodel-lite", "ddmodel-lite-deep", "ddmodel-lite-no-transformer"),
                         [](const auto& info) {
                             std::string name = info.param;
                             std::erase(name, '-');
                             return name;
                         });

}  // namespace
}  // namespace ddtool::train_torch

#include <benchmark/benchmark.h>
#include <torch/torch.h>

#include "train/torch/losses.hpp"
#include "train/torch/mixed_precision.hpp"
#include "train/torch/network.hpp"
#include "train/torch/optimizers.hpp"

namespace ddtool {
namespace {

constexpr std::int64_t batch_size = 32;
constexpr std::int64_t size_px = 224;

torch::Tensor drawn_images(std::int64_t count) {
    torch::manual_seed(1);
    return torch::rand({count, 1, size_px, size_px})
        .gt(0.999)
        .to(torch::kFloat)
        .contiguous(torch::MemoryFormat::ChannelsLast);
}

std::shared_ptr<train_torch::Network> drawn_network(const std::string& name) {
    torch::set_num_threads(1);
    torch::manual_seed(1);
    return train_torch::make_network(name, size_px);
}

/// Measures one training step, as Trainer does it: forward, loss, backward, clipping of the gradients, and the step of
/// Adam.
void training_step(benchmark::State& state, const std::string& name, const std::string& precision) {
    const std::shared_ptr<train_torch::Network> network = drawn_network(name);
    network->train();
    const std::vector<torch::Tensor> parameters = network->parameters();
    const auto optimizer = train_torch::make_optimizer({}, parameters);
    const torch::Tensor images = drawn_images(batch_size);
    const torch::Tensor classes = torch::arange(batch_size).remainder(2);
    for ([[maybe_unused]] auto _ : state) {
        torch::Tensor logits;
        {
            const train_torch::MixedPrecision mixed(precision, torch::kCPU);
            logits = network->forward(images);
        }
        optimizer->zero_grad();
        train_torch::sample_losses("cross-entropy", logits, classes).mean().backward();
        torch::nn::utils::clip_grad_norm_(parameters, 1.0);
        optimizer->step();
    }
}
BENCHMARK_CAPTURE(training_step, ddmodel_lite_fp32, "ddmodel-lite", "fp32")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(training_step, ddmodel_lite_bf16, "ddmodel-lite", "bf16")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(training_step, ddmodel_fp32, "ddmodel", "fp32")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(training_step, ddmodel_bf16, "ddmodel", "bf16")->Unit(benchmark::kMillisecond);

/// Measures the forward pass of one image in the network as it was trained, not exported.
void plain_forward(benchmark::State& state, const std::string& name) {
    const torch::NoGradGuard no_grad;
    const std::shared_ptr<train_torch::Network> network = drawn_network(name);
    network->eval();
    const torch::Tensor image = drawn_images(1);
    for ([[maybe_unused]] auto _ : state) {
        benchmark::DoNotOptimize(network->forward(image));
    }
}
BENCHMARK_CAPTURE(plain_forward, ddmodel_lite, "ddmodel-lite")->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(plain_forward, ddmodel, "ddmodel")->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace ddtool

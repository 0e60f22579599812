#include "network/folded_kernel.hpp"

#include <cmath>

namespace ddtool::network {
namespace {

constexpr double batch_norm_epsilon = 1e-5;

}  // namespace

FoldedKernel folded_kernel(NamedWeights& weights, const std::string& prefix, std::size_t outputs, std::size_t inputs,
                           std::size_t kernel_px) {
    FoldedKernel kernel{weights.take(prefix + ".conv.weight", {outputs, inputs, kernel_px, kernel_px}),
                        Floats(outputs)};
    const std::vector<float> factor = weights.take(prefix + ".norm.weight", {outputs});
    const std::vector<float> shift = weights.take(prefix + ".norm.bias", {outputs});
    const std::vector<float> mean = weights.take(prefix + ".norm.running_mean", {outputs});
    const std::vector<float> variance = weights.take(prefix + ".norm.running_var", {outputs});
    const std::size_t count = inputs * kernel_px * kernel_px;
    for (std::size_t output = 0; output < outputs; ++output) {
        const double scale = factor[output] / std::sqrt(variance[output] + batch_norm_epsilon);
        kernel.bias[output] = static_cast<float>(shift[output] - mean[output] * scale);
        for (std::size_t index = output * count; index < (output + 1) * count; ++index) {
            kernel.values[index] = static_cast<float>(kernel.values[index] * scale);
        }
    }
    return kernel;
}

}  // namespace ddtool::network

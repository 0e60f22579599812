#include "train/torch/mixed_precision.hpp"

#include <ATen/autocast_mode.h>
#include <torch/version.h>

namespace ddtool::train_torch {
namespace {

void set_autocast(torch::DeviceType device, bool on) {
#if TORCH_VERSION_MAJOR > 2 || (TORCH_VERSION_MAJOR == 2 && TORCH_VERSION_MINOR >= 4)
    at::autocast::set_autocast_enabled(device, on);
    at::autocast::set_autocast_dtype(device, at::kBFloat16);
#else
    if (device == torch::kCUDA) {
        at::autocast::set_enabled(on);
        at::autocast::set_autocast_gpu_dtype(at::kBFloat16);
    } else {
        at::autocast::set_cpu_enabled(on);
        at::autocast::set_autocast_cpu_dtype(at::kBFloat16);
    }
#endif
}

}  // namespace

MixedPrecision::MixedPrecision(const std::string& precision, torch::DeviceType device)
    : on_(precision == "bf16"), device_(device) {
    if (on_) {
        set_autocast(device_, true);
    }
}

MixedPrecision::~MixedPrecision() {
    if (on_) {
        at::autocast::clear_cache();
        set_autocast(device_, false);
    }
}

}  // namespace ddtool::train_torch

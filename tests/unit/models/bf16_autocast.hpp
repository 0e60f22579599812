#pragma once

#include <ATen/autocast_mode.h>
#include <torch/version.h>

namespace ddtool::models {

/// While one lives, the processor's operations that gain from it run in bf16, as in training.
class Bf16Autocast {
public:
    Bf16Autocast() { set(true); }
    ~Bf16Autocast() {
        at::autocast::clear_cache();
        set(false);
    }
    Bf16Autocast(const Bf16Autocast&) = delete;
    Bf16Autocast& operator=(const Bf16Autocast&) = delete;

private:
    static void set(bool on) {
#if TORCH_VERSION_MAJOR > 2 || (TORCH_VERSION_MAJOR == 2 && TORCH_VERSION_MINOR >= 4)
        at::autocast::set_autocast_enabled(at::kCPU, on);
#else
        at::autocast::set_cpu_enabled(on);
#endif
    }
};

}  // namespace ddtool::models

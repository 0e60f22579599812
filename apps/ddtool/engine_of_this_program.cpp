#include "engine_provider.hpp"
#include "surroundings.hpp"
#include "train/torch/torch_engine.hpp"

namespace ddtool {

const train::Engine& provide_engine() {
    expect_memory_for_libtorch();
    return train_torch::torch_engine();
}

}  // namespace ddtool

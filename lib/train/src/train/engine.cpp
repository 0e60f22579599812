#include "train/engine.hpp"

#include "ddtool/base/error.hpp"

namespace ddtool::train {
namespace {

EngineProvider provider = nullptr;

}  // namespace

void set_engine_provider(EngineProvider new_provider) { provider = new_provider; }

const Engine& engine() {
    if (provider == nullptr) {
        throw Error("this needs LibTorch, which this program was built without (DDTOOL_WITH_TORCH)");
    }
    return provider();
}

}  // namespace ddtool::train

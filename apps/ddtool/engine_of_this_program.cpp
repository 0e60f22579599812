#include "engine/torch_engine.hpp"
#include "engine_provider.hpp"

namespace ddtool {

const learning::Engine& provide_engine() { return torch_engine(); }

}  // namespace ddtool

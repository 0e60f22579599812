#include "engine_provider.hpp"
#include "other_program.hpp"

namespace ddtool {

const train::Engine& provide_engine() { become_other_program("ddtool-torch", "LibTorch"); }

}  // namespace ddtool

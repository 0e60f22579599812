#include "ddtool/filter/patch.hpp"

namespace ddtool {

Patch* const PatchPointer::empty_ = new Patch;  // lives as long as the program

}  // namespace ddtool

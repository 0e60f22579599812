#include "ddtool/filter/patch.hpp"

namespace ddtool {

Patch* const PatchPointer::empty_ = new Patch;  // never deleted: it is used as long as the program runs

}  // namespace ddtool

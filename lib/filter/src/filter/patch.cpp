#include "ddtool/filter/patch.hpp"

namespace ddtool {

template <>
Patch* const CopyOnWrite<Patch>::empty_ = new Patch;  // never deleted: it is used as long as the program runs

}  // namespace ddtool

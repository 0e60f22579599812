#pragma once

#include <pybind11/pybind11.h>

namespace ddtool::python {

namespace py = pybind11;

}  // namespace ddtool::python

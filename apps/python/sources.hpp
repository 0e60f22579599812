#pragma once

#include "py.hpp"

namespace ddtool::python {

/// Registers ddtool.Log, open_log() and their types.
void add_logs(py::module_& module);
/// Registers ddtool.Simulation, simulate() and worlds().
void add_simulations(py::module_& module);
/// Registers ddtool.Dataset and open_dataset().
void add_datasets(py::module_& module);

}  // namespace ddtool::python

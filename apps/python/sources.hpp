#pragma once

#include <pybind11/pybind11.h>

namespace ddtool::python {

/// Registers ddtool.Log, open_log() and their types.
void add_logs(pybind11::module_& module);
/// Registers ddtool.Simulation, simulate() and worlds().
void add_simulations(pybind11::module_& module);
/// Registers ddtool.Dataset and open_dataset().
void add_datasets(pybind11::module_& module);

}  // namespace ddtool::python

#include <pybind11/pybind11.h>

#include "grid_map.hpp"
#include "host.hpp"
#include "run.hpp"
#include "scan.hpp"
#include "sources.hpp"
#include "swarm.hpp"
#include "trajectory.hpp"

PYBIND11_MODULE(_ddtool, module) {
    namespace python = ddtool::python;
    // Users see the package: names, messages and pickles say ddtool.Slam, wherever the class is compiled.
    module.attr("__name__") = "ddtool";
    python::add_errors(module);
    python::log_to_python();
    python::add_scans(module);
    python::add_trajectories(module);
    python::add_swarms(module);
    python::add_maps(module);
    python::add_runs(module);
    python::add_logs(module);
    python::add_simulations(module);
    python::add_datasets(module);
    module.attr("__version__") = DDTOOL_VERSION;
    module.attr("__name__") = "ddtool._ddtool";
}

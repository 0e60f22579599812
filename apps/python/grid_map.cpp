#include "grid_map.hpp"

#include <string>

#include "arrays.hpp"
#include "ddtool/base/error.hpp"
#include "host.hpp"
#include "maps/any_map.hpp"
#include "report/map_files.hpp"

namespace ddtool::python {
namespace {

py::array cells_view(const std::vector<std::int8_t>& cells, const HeldMap& map, const py::object& self) {
    const auto width = static_cast<py::ssize_t>(map.raster.width);
    return view(cells.data(), {static_cast<py::ssize_t>(map.raster.height), width}, {width, 1}, self);
}

/// Writes NAME.pgm and NAME.yaml for a path that ends with .yaml.
void write_map_server_files(const HeldMap& map, const py::object& path) {
    const std::filesystem::path file = py::module_::import("os").attr("fspath")(path).cast<std::string>();
    if (file.extension() != ".yaml" || file.stem().empty()) {
        throw UsageError(file.string() +
                         ": expected a name that ends with .yaml; the picture beside it ends with .pgm");
    }
    without_gil([&] { write_map_files(file.parent_path(), file.stem().string(), map.raster); });
}

}  // namespace

void add_maps(py::module_& module) {
    py::class_<HeldMap, std::shared_ptr<HeldMap>>(module, "Map",
                                                  R"(An occupancy grid: what was observed, and nothing around it.

Row 0 is the lowest y and column 0 the lowest x: cell [row, column] covers origin + resolution * (column .. column + 1,
row .. row + 1). Arrays are read-only views of this map, which later updates do not change.)")
        .def_property_readonly(
            "occupancy",
            [](const py::object& self) {
                const auto& map = self.cast<const HeldMap&>();
                return cells_view(map.raster.cells, map, self);
            },
            "(H, W) int8: 0 free, 100 occupied, -1 unknown, as nav_msgs/OccupancyGrid has it.")
        .def_property_readonly(
            "log_odds",
            [](const py::object& self) {
                const auto& map = self.cast<const HeldMap&>();
                return cells_view(map.log_odds, map, self);
            },
            "(H, W) int8: log odds in steps: above 0 occupied, else free; -128 unknown. The settings filter.grid.* say "
            "how many steps an observation counts.")
        .def_property_readonly(
            "resolution_m", [](const HeldMap& map) { return map.raster.cell_size_m; }, "Side of a cell in metres.")
        .def_property_readonly(
            "origin_m",
            [](const HeldMap& map) { return py::make_tuple(map.raster.origin_m.x_m, map.raster.origin_m.y_m); },
            "(x, y) of the lower left corner of the first cell in the world, in metres.")
        .def("write", &write_map_server_files, py::arg("path"),
             "Writes PATH.yaml and the picture PATH.pgm beside it, as ROS's map_server and nav2 read them.")
        .def("__repr__", [](const HeldMap& map) {
            return "<ddtool.Map of " + std::to_string(map.raster.width) + " x " + std::to_string(map.raster.height) +
                   " cells>";
        });
    module.def(
        "read_map",
        [](const py::object& path) {
            const std::filesystem::path file = existing_path(path);
            return without_gil(
                [&] { return std::make_shared<HeldMap>(maps::read_any_map(file, maps::MapParts::grid).grid); });
        },
        py::arg("path"),
        "Reads a saved map: a map.ddmap of a run, a map.yaml of map_server or nav2, or a folder with either.");
}

}  // namespace ddtool::python

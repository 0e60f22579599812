#pragma once

#include <pybind11/numpy.h>

#include <span>
#include <string>
#include <vector>

#include "ddtool/robot/pose2.hpp"
#include "ddtool/robot/trajectory.hpp"
#include "py.hpp"

namespace ddtool::python {

/// Makes an array read-only, for good where it does not own its memory: NumPy lets nobody change that.
py::array sealed(py::array array);

/// A read-only array over memory that `owner` keeps, without copying. The array keeps `owner` alive.
template <typename Item>
py::array view(const Item* items, const std::vector<py::ssize_t>& shape, const std::vector<py::ssize_t>& strides,
               const py::object& owner) {
    return sealed(py::array(py::dtype::of<Item>(), shape, strides, items, owner));
}

/// A view of shape (items.size(),).
template <typename Item>
py::array view(std::span<const Item> items, const py::object& owner) {
    return view(items.data(), {static_cast<py::ssize_t>(items.size())}, {sizeof(Item)}, owner);
}

/// One number of each row of plain structs: shape (rows.size(),).
template <typename Row, typename Item>
py::array column_view(std::span<const Row> rows, Item Row::*member, const py::object& owner) {
    const Item* const first = rows.empty() ? nullptr : &(rows.front().*member);
    return view(first, {static_cast<py::ssize_t>(rows.size())}, {sizeof(Row)}, owner);
}

/// One pose of each row: shape (rows.size(), 3), of x in m, y in m and heading in rad.
template <typename Row>
py::array pose_column_view(std::span<const Row> rows, Pose2 Row::*member, const py::object& owner) {
    static_assert(sizeof(Pose2) == 3 * sizeof(double));
    const double* const first = rows.empty() ? nullptr : &(rows.front().*member).x_m;
    return view(first, {static_cast<py::ssize_t>(rows.size()), 3}, {sizeof(Row), sizeof(double)}, owner);
}

/// A view of shape (3,).
py::array pose_view(const Pose2& pose, const py::object& owner);

/// Reads a pose from a sequence of three finite numbers. Throws UsageError that begins with `name`.
Pose2 pose_from(const py::object& value, const std::string& name);

/// Reads an array of `dimensions` axes whose last one has `columns` entries if that is not 0. Throws UsageError that
/// begins with `name` for another shape and for what are no numbers; `form` says in words what was expected.
py::array_t<double, py::array::c_style> numbers_from(const py::object& value, py::ssize_t dimensions,
                                                     py::ssize_t columns, const std::string& name,
                                                     const std::string& form);

}  // namespace ddtool::python

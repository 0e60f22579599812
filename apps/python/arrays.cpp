#include "arrays.hpp"

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"

namespace ddtool::python {

py::array sealed(py::array array) {
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

py::array pose_view(const Pose2& pose, const py::object& owner) {
    return view(&pose.x_m, {3}, {sizeof(double)}, owner);
}

py::array_t<double, py::array::c_style> numbers_from(const py::object& value, py::ssize_t dimensions,
                                                     py::ssize_t columns, const std::string& name,
                                                     const std::string& form) {
    using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;
    const Numbers numbers = Numbers::ensure(value);
    if (!numbers || py::isinstance<py::str>(value) || numbers.ndim() != dimensions ||
        (columns > 0 && numbers.shape(dimensions - 1) != columns)) {
        PyErr_Clear();
        throw UsageError(name + ": expected " + form);
    }
    return numbers;
}

Pose2 pose_from(const py::object& value, const std::string& name) {
    const std::string form = "three finite numbers: x and y in metres, heading in radians";
    const auto numbers = numbers_from(value, 1, 3, name, form);
    if (!std::all_of(numbers.data(), numbers.data() + 3, [](double number) { return std::isfinite(number); })) {
        throw UsageError(name + ": expected " + form);
    }
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

}  // namespace ddtool::python

#include "callable_detector.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "swarm.hpp"

namespace ddtool::python {
namespace {

std::string type_name(const py::handle& value) { return py::str(py::type::handle_of(value).attr("__name__")); }

/// A Python number, also one of NumPy or a tensor of one element.
double answered_number(const py::handle& answer, const char* what) {
    PyObject* const number = PyUnicode_Check(answer.ptr()) != 0 || PyBytes_Check(answer.ptr()) != 0 || answer.is_none()
                                 ? nullptr
                                 : PyNumber_Float(answer.ptr());
    if (number == nullptr) {
        PyErr_Clear();
        throw py::type_error(std::string("the detector returned ") + type_name(answer) + " as " + what +
                             "; expected a degree from 0 to 1, or (degree, direction in radians)");
    }
    return py::reinterpret_steal<py::float_>(number).cast<double>();
}

}  // namespace

Degeneracy CallableDetector::ask(const ParticleSnapshot& swarm) {
    const py::gil_scoped_acquire gil;
    try {
        // A copy, because the callable may keep it, or a view of it.
        const py::object answer =
            callable_(std::make_shared<HeldSwarm>(std::make_shared<const ParticleSnapshot>(swarm)));
        const bool is_pair = py::isinstance<py::tuple>(answer) && py::len(answer) == 2;
        const py::object degree_answer = is_pair ? py::object(answer[py::int_(0)]) : answer;
        const double degree = answered_number(degree_answer, "degree");
        if (!(degree >= 0.0 && degree <= 1.0)) {
            throw UsageError("the detector returned the degree " + std::string(py::str(py::float_(degree))) +
                             "; expected a number from 0 to 1");
        }
        if (is_pair && !answer[py::int_(1)].is_none()) {
            const double direction_rad = answered_number(answer[py::int_(1)], "direction");
            if (!std::isfinite(direction_rad)) {
                throw UsageError("the detector returned a direction that is not finite; expected radians or None");
            }
            direction_rad_ = direction_rad;
        }
        return {degree};
    } catch (...) {
        failure_ = std::current_exception();
        return {};
    }
}

void CallableDetector::raise_failure() {
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
}

std::optional<double> CallableDetector::take_direction() { return std::exchange(direction_rad_, std::nullopt); }

}  // namespace ddtool::python

#pragma once

#include <exception>
#include <optional>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "py.hpp"

namespace ddtool::python {

/// A Python callable as a detector: it gets the ddtool.Swarm and returns a degree, or a degree and a direction. What it
/// raises must not tear the update apart, so it is kept, the degree of that update is 0, and raise_failure() throws it
/// when the filter is done.
class CallableDetector {
public:
    explicit CallableDetector(py::object callable) : callable_(std::move(callable)) {}

    /// Takes the GIL for the call.
    Degeneracy ask(const ParticleSnapshot& swarm);
    /// Call it with the GIL after each update.
    void raise_failure();
    /// The direction that the callable gave since this was last called, in radians in the world; empty if it gave none.
    std::optional<double> take_direction();

    /// For Python's search for cycles.
    [[nodiscard]] const py::object& callable() const { return callable_; }
    /// Gives up the callable. Must not be asked afterwards.
    void clear() { callable_ = py::none(); }

private:
    py::object callable_;
    std::exception_ptr failure_;
    std::optional<double> direction_rad_;
};

}  // namespace ddtool::python

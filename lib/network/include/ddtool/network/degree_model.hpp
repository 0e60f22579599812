#pragma once

#include <span>

#include "ddtool/network/model_description.hpp"

namespace ddtool::native {

/// A trained network, ready to run. One thread at a time.
class DegreeModel {
public:
    virtual ~DegreeModel() = default;
    [[nodiscard]] virtual const ModelDescription& description() const = 0;
    /// images: degrees.size() images one after the other, size_px * size_px floats each, 0 or 1, rows from the top.
    /// degrees: c in 0..1 of each.
    virtual void run(std::span<const float> images, std::span<double> degrees) = 0;
};

}  // namespace ddtool::native

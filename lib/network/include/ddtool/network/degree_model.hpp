#pragma once

#include <span>

#include "ddtool/network/model_description.hpp"

namespace ddtool {

/// A trained network, ready to run. An object may be used by one thread at a time.
class DegreeModel {
public:
    virtual ~DegreeModel() = default;
    [[nodiscard]] virtual const ModelDescription& description() const = 0;
    /// images: degrees.size() images one after the other, size_px * size_px floats each, with values 0 or 1, rows from
    /// the top. degrees: filled with the degree c in 0..1 of each image. Throws Error for images of another size.
    virtual void run(std::span<const float> images, std::span<double> degrees) = 0;
};

}  // namespace ddtool

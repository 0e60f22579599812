#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "report/axes.hpp"

namespace ddtool::report {

struct FigureLayout {
    double width_px = 1000.0;
    double height_px = 700.0;
    std::vector<double> row_shares{1.0};  ///< heights of the rows, in any unit
    std::size_t columns = 1;
};

/// Axes in rows and columns on one white page.
class Figure {
public:
    explicit Figure(FigureLayout layout = {});

    /// The axes in that place; row 0 is at the top. Places without axes stay white.
    Axes& axes(std::size_t row = 0, std::size_t column = 0);

    /// The figure as a picture, BGR.
    [[nodiscard]] cv::Mat3b render() const;
    /// Writes the figure as PNG. Throws Error naming the file if it cannot be written.
    void write_png(const std::filesystem::path& path) const;

private:
    FigureLayout layout_;
    std::vector<std::optional<Axes>> axes_;  ///< row by row
};

}  // namespace ddtool::report

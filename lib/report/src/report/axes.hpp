#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/canvas.hpp"
#include "system/png_file.hpp"

namespace ddtool::report {

/// A range of values from low to high; empty until a value is included.
struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();

    /// Extends the range to contain the value. A value that is not finite is ignored.
    void include(double value);
    [[nodiscard]] double length() const { return high - low; }
};

/// The part of the data plane that an axes box shows.
struct View {
    Range x;
    Range y;
    double width_px = 0.0;
    double height_px = 0.0;

    [[nodiscard]] Pixel pixel(double x_value, double y_value) const;
};

struct LineStyle {
    std::string label;  ///< for the legend; empty: no entry
    Colour colour = series_colour(0);
    double width_px = 1.5;
};

struct BarSeries {
    std::string label;
    std::vector<double> heights;  ///< one per name
};

/// A pair of axes with what is drawn in it. Layers are drawn on top of each other in the order in which they were
/// added; data that are not finite are left out. Every function that adds a layer copies its data and returns the axes,
/// so that calls can be chained.
class Axes {
public:
    Axes& title(std::string text);
    Axes& x_label(std::string text);
    Axes& y_label(std::string text);
    /// Shows this range instead of the range of the data.
    Axes& x_range(double low, double high);
    Axes& y_range(double low, double high);
    /// Draws one unit equally long in x and in y, for maps and paths.
    Axes& equal_aspect();

    Axes& line(std::span<const double> x, std::span<const double> y, const LineStyle& style = {});
    Axes& scatter(std::span<const double> x, std::span<const double> y, const LineStyle& style = {});
    /// A line coloured by a value at each point, from 0 to the largest, with a colour bar beside the axes.
    Axes& heat_line(std::span<const double> x, std::span<const double> y, std::span<const double> value,
                    const std::string& bar_label);
    /// The area between two curves, e.g. quartiles.
    Axes& band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour);
    /// Groups of bars: one group per name, and in it one bar per series.
    Axes& bars(const std::vector<std::string>& names, const std::vector<BarSeries>& series);
    /// A histogram: how many values fall in each of `bins` equal parts of their range.
    Axes& histogram(std::span<const double> values, std::size_t bins, const LineStyle& style = {});
    /// A picture, e.g. a map, over the ranges x and y; its first row is at y.high.
    Axes& picture(const PixelView& pixels, const Range& x, const Range& y);

    /// Draws frame, ticks, texts and layers into the box.
    void draw(Canvas& canvas, const Box& box) const;

private:
    using Painter = std::function<void(Canvas& canvas, const View& view)>;
    struct LegendEntry {
        std::string label;
        Colour colour;
    };
    struct ColourBar {
        std::string label;
        double high = 0.0;
    };
    struct Frame;

    void add(const std::string& label, Colour colour, Painter paint);
    void include(std::span<const double> x, std::span<const double> y);
    [[nodiscard]] Frame frame_in(const Box& box) const;
    [[nodiscard]] View view_of(const Box& frame) const;
    void draw_ticks(Canvas& canvas, const Frame& frame) const;
    void draw_texts(Canvas& canvas, const Frame& frame) const;
    void draw_legend(Canvas& canvas, const Frame& frame) const;
    void draw_colour_bar(Canvas& canvas, const Frame& frame) const;

    std::string title_;
    std::string x_label_;
    std::string y_label_;
    bool equal_aspect_ = false;
    Range data_x_;
    Range data_y_;
    std::optional<Range> fixed_x_;
    std::optional<Range> fixed_y_;
    std::vector<std::string> x_names_;  ///< of bars, instead of numbers along x
    std::vector<Painter> painters_;
    std::vector<LegendEntry> legend_;
    std::optional<ColourBar> colour_bar_;
};

}  // namespace ddtool::report

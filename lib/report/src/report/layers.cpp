#include <algorithm>
#include <cmath>

#include "report/axes.hpp"

namespace ddtool::report {
namespace {

using Numbers = std::vector<double>;

Numbers copy_of(std::span<const double> values) { return {values.begin(), values.end()}; }

std::vector<Pixel> pixels_of(const View& view, const Numbers& x, const Numbers& y) {
    std::vector<Pixel> pixels;
    for (std::size_t i = 0; i < x.size(); ++i) {
        pixels.push_back(view.pixel(x[i], y[i]));
    }
    return pixels;
}

/// Fills a bar from 0 to its height.
void fill_bar(Canvas& canvas, const View& view, const Range& x, double height, Colour colour) {
    if (!std::isfinite(height)) {
        return;
    }
    const Pixel top_left = view.pixel(x.low, std::max(0.0, height));
    const Pixel bottom_right = view.pixel(x.high, std::min(0.0, height));
    canvas.fill({top_left.x_px, top_left.y_px, bottom_right.x_px - top_left.x_px, bottom_right.y_px - top_left.y_px},
                colour);
}

}  // namespace

void Axes::add(const std::string& label, Colour colour, Painter paint) {
    painters_.push_back(std::move(paint));
    if (!label.empty()) {
        legend_.push_back({label, colour});
    }
}

void Axes::include(std::span<const double> x, std::span<const double> y) {
    std::for_each(x.begin(), x.end(), [&](double value) { data_x_.include(value); });
    std::for_each(y.begin(), y.end(), [&](double value) { data_y_.include(value); });
}

Axes& Axes::line(std::span<const double> x, std::span<const double> y, const LineStyle& style) {
    include(x, y);
    add(style.label, style.colour, [x = copy_of(x), y = copy_of(y), style](Canvas& canvas, const View& view) {
        canvas.path(pixels_of(view, x, y), style.colour, style.width_px);
    });
    return *this;
}

Axes& Axes::scatter(std::span<const double> x, std::span<const double> y, const LineStyle& style) {
    include(x, y);
    add(style.label, style.colour, [x = copy_of(x), y = copy_of(y), style](Canvas& canvas, const View& view) {
        for (const Pixel& pixel : pixels_of(view, x, y)) {
            canvas.disc(pixel, 1.5 * style.width_px, style.colour);
        }
    });
    return *this;
}

Axes& Axes::heat_line(std::span<const double> x, std::span<const double> y, std::span<const double> value,
                      const std::string& bar_label) {
    include(x, y);
    Range values{0.0, 0.0};
    std::for_each(value.begin(), value.end(), [&](double v) { values.include(v); });
    colour_bar_ = ColourBar{bar_label, values.high};
    const double scale = values.high > 0.0 ? 1.0 / values.high : 0.0;
    add("", black, [x = copy_of(x), y = copy_of(y), value = copy_of(value), scale](Canvas& canvas, const View& view) {
        const std::vector<Pixel> pixels = pixels_of(view, x, y);
        for (std::size_t i = 1; i < pixels.size(); ++i) {
            canvas.path({pixels[i - 1], pixels[i]}, heat_colour(scale * value[i]), 3.5);
        }
    });
    return *this;
}

Axes& Axes::band(std::span<const double> x, std::span<const double> low, std::span<const double> high, Colour colour) {
    include(x, low);
    include(x, high);
    add("", colour,
        [x = copy_of(x), low = copy_of(low), high = copy_of(high), colour](Canvas& canvas, const View& view) {
            std::vector<Pixel> outline = pixels_of(view, x, low);
            const std::vector<Pixel> upper = pixels_of(view, x, high);
            outline.insert(outline.end(), upper.rbegin(), upper.rend());
            canvas.shade(outline, colour);
        });
    return *this;
}

Axes& Axes::bars(const std::vector<std::string>& names, const std::vector<BarSeries>& series) {
    x_names_ = names;
    include(std::vector{-0.5, static_cast<double>(names.size()) - 0.5}, std::vector{0.0});
    const double bar_width = 0.8 / static_cast<double>(series.size());
    for (std::size_t s = 0; s < series.size(); ++s) {
        include({}, series[s].heights);
        const double left = -0.4 + bar_width * static_cast<double>(s);
        const Colour colour = series_colour(s);
        add(series[s].label, colour,
            [heights = series[s].heights, left, bar_width, colour](Canvas& canvas, const View& view) {
                for (std::size_t name = 0; name < heights.size(); ++name) {
                    const double x = static_cast<double>(name) + left;
                    fill_bar(canvas, view, {x, x + bar_width}, heights[name], colour);
                }
            });
    }
    return *this;
}

Axes& Axes::histogram(std::span<const double> values, std::size_t bins, const LineStyle& style) {
    Range range;
    std::for_each(values.begin(), values.end(), [&](double value) { range.include(value); });
    if (range.low > range.high) {
        return *this;
    }
    const double width = range.length() > 0.0 ? range.length() / static_cast<double>(bins) : 1.0;
    Numbers counts(bins, 0.0);
    for (const double value : values) {
        if (std::isfinite(value)) {
            counts[std::min(bins - 1, static_cast<std::size_t>((value - range.low) / width))] += 1.0;
        }
    }
    include(std::vector{range.low, range.low + width * static_cast<double>(bins)}, std::vector{0.0});
    include({}, counts);
    add(style.label, style.colour,
        [counts, low = range.low, width, colour = style.colour](Canvas& canvas, const View& view) {
            for (std::size_t bin = 0; bin < counts.size(); ++bin) {
                const double x = low + width * static_cast<double>(bin);
                fill_bar(canvas, view, {x, x + 0.95 * width}, counts[bin], colour);
            }
        });
    return *this;
}

Axes& Axes::picture(const PixelView& pixels, const Range& x, const Range& y) {
    include(std::vector{x.low, x.high}, std::vector{y.low, y.high});
    const int type = pixels.channels == 1 ? CV_8UC1 : CV_8UC3;
    cv::Mat copy(static_cast<int>(pixels.height_px), static_cast<int>(pixels.width_px), type);
    std::copy(pixels.pixels.begin(), pixels.pixels.end(), copy.data);
    add("", black, [copy, x, y](Canvas& canvas, const View& view) {
        const Pixel top_left = view.pixel(x.low, y.high);
        const Pixel bottom_right = view.pixel(x.high, y.low);
        canvas.picture(
            copy, {top_left.x_px, top_left.y_px, bottom_right.x_px - top_left.x_px, bottom_right.y_px - top_left.y_px});
    });
    return *this;
}

}  // namespace ddtool::report

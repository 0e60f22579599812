#include "report/axes.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/ticks.hpp"

namespace ddtool::report {
namespace {

constexpr double title_height_px = 12.0;
constexpr double label_height_px = 10.0;
constexpr double tick_height_px = 9.0;
constexpr double x_tick_spacing_px = 80.0;
constexpr double y_tick_spacing_px = 45.0;
constexpr double gap_px = 8.0;
constexpr double legend_row_px = 2.0 * label_height_px;
constexpr double swatch_width_px = 22.0;
constexpr double colour_bar_width_px = 14.0;

/// The range with a margin on both sides. An empty range becomes 0..1, and a single value gets a range around it.
Range with_margin(const Range& range) {
    if (range.low > range.high) {
        return {0.0, 1.0};
    }
    const double smallest = 1e-6 * std::max({1.0, std::abs(range.low), std::abs(range.high)});
    const double margin = range.length() > smallest ? 0.04 * range.length() : 0.5;
    return {range.low - margin, range.high + margin};
}

Range widened_to(const Range& range, double length) {
    const double middle = 0.5 * (range.low + range.high);
    return {middle - 0.5 * length, middle + 0.5 * length};
}

std::size_t ticks_that_fit(double length_px, double each_px) {
    return std::max<std::size_t>(2, static_cast<std::size_t>(length_px / each_px));
}

}  // namespace

void Range::include(double value) {
    if (std::isfinite(value)) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
}

Pixel View::pixel(double x_value, double y_value) const {
    return {(x_value - x.low) / x.length() * width_px, (y.high - y_value) / y.length() * height_px};
}

/// The position of each part of the axes on the page.
struct Axes::Frame {
    Box outer;
    Box inner;  ///< the area in which the data are drawn
    View view;
    Ticks x_ticks;
    Ticks y_ticks;
    std::vector<std::vector<LegendEntry>> legend_rows;
};

Axes& Axes::title(std::string text) {
    title_ = std::move(text);
    return *this;
}

Axes& Axes::x_label(std::string text) {
    x_label_ = std::move(text);
    return *this;
}

Axes& Axes::y_label(std::string text) {
    y_label_ = std::move(text);
    return *this;
}

Axes& Axes::x_range(double low, double high) {
    fixed_x_ = Range{low, high};
    return *this;
}

Axes& Axes::y_range(double low, double high) {
    fixed_y_ = Range{low, high};
    return *this;
}

Axes& Axes::equal_aspect() {
    equal_aspect_ = true;
    return *this;
}

View Axes::view_of(const Box& frame) const {
    View view{fixed_x_.value_or(with_margin(data_x_)), fixed_y_.value_or(with_margin(data_y_)), frame.width_px,
              frame.height_px};
    if (equal_aspect_) {
        const double units_per_px = std::max(view.x.length() / view.width_px, view.y.length() / view.height_px);
        view.x = widened_to(view.x, units_per_px * view.width_px);
        view.y = widened_to(view.y, units_per_px * view.height_px);
    }
    return view;
}

namespace {

double entry_width_px(const std::string& label) {
    return swatch_width_px + 3.0 * gap_px + Canvas::text_width_px(label, label_height_px);
}

/// Arranges the entries of the legend side by side, in as many rows as the width requires.
template <typename Entry>
std::vector<std::vector<Entry>> in_rows(const std::vector<Entry>& entries, double width_px) {
    std::vector<std::vector<Entry>> rows;
    double used_px = 0.0;
    for (const Entry& entry : entries) {
        const double entry_px = entry_width_px(entry.label);
        if (rows.empty() || used_px + entry_px > width_px) {
            rows.emplace_back();
            used_px = 0.0;
        }
        rows.back().push_back(entry);
        used_px += entry_px;
    }
    return rows;
}

double widest_tick_px(const Ticks& ticks) {
    double widest = 0.0;
    for (const double place : ticks.places) {
        widest = std::max(widest, Canvas::text_width_px(tick_text(place, ticks.decimals), tick_height_px));
    }
    return widest;
}

}  // namespace

Axes::Frame Axes::frame_in(const Box& box) const {
    Frame frame{.outer = box, .inner = box, .view = {}, .x_ticks = {}, .y_ticks = {}, .legend_rows = {}};
    const double right_px = colour_bar_ ? colour_bar_width_px + 90.0 : 2.0 * gap_px;
    frame.legend_rows = in_rows(legend_, box.width_px - 80.0 - right_px);
    const double top_px = (title_.empty() ? gap_px : 2.5 * title_height_px) +
                          legend_row_px * static_cast<double>(frame.legend_rows.size());
    const double bottom_px = (x_label_.empty() ? 0.0 : 2.2 * label_height_px) + 2.0 * tick_height_px + gap_px;
    frame.inner.top_px += top_px;
    frame.inner.height_px -= top_px + bottom_px;
    const double y_tick_px = equal_aspect_ ? 60.0 : y_tick_spacing_px;
    // The left margin depends on the width of the tick texts, and these depend on the ticks. The ticks in turn hardly
    // depend on the margin, so a second pass with the width from the first is enough.
    const auto set_left = [&](double left_px) {
        frame.inner.left_px = box.left_px + left_px;
        frame.inner.width_px = box.width_px - left_px - right_px;
        frame.view = view_of(frame.inner);
        frame.y_ticks =
            nice_ticks(frame.view.y.low, frame.view.y.high, ticks_that_fit(frame.inner.height_px, y_tick_px));
    };
    const double label_px = y_label_.empty() ? gap_px : 2.5 * label_height_px;
    set_left(label_px + 40.0);
    set_left(label_px + 2.0 * gap_px + widest_tick_px(frame.y_ticks));
    frame.x_ticks =
        nice_ticks(frame.view.x.low, frame.view.x.high, ticks_that_fit(frame.inner.width_px, x_tick_spacing_px));
    return frame;
}

void Axes::draw(Canvas& canvas, const Box& box) const {
    const Frame frame = frame_in(box);
    draw_ticks(canvas, frame);
    Canvas inside = canvas.window(frame.inner);
    for (const Painter& paint : painters_) {
        paint(inside, frame.view);
    }
    draw_texts(canvas, frame);
    draw_legend(canvas, frame);
    draw_colour_bar(canvas, frame);
}

void Axes::draw_ticks(Canvas& canvas, const Frame& frame) const {
    const Box& inner = frame.inner;
    const double bottom_px = inner.top_px + inner.height_px;
    const double right_px = inner.left_px + inner.width_px;
    for (const double place : frame.y_ticks.places) {
        const double y_px = inner.top_px + frame.view.pixel(0.0, place).y_px;
        canvas.line({inner.left_px, y_px}, {right_px, y_px}, light_grey, 1.0);
        canvas.text({inner.left_px - gap_px, y_px}, tick_text(place, frame.y_ticks.decimals), tick_height_px,
                    Anchor::right);
    }
    const auto x_text = [&](double place, const std::string& text) {
        const double x_px = inner.left_px + frame.view.pixel(place, 0.0).x_px;
        canvas.text({x_px, bottom_px + gap_px + tick_height_px / 2.0}, text, tick_height_px);
        return x_px;
    };
    for (std::size_t name = 0; name < x_names_.size(); ++name) {
        x_text(static_cast<double>(name), x_names_[name]);
    }
    for (const double place : x_names_.empty() ? frame.x_ticks.places : std::vector<double>{}) {
        const double x_px = x_text(place, tick_text(place, frame.x_ticks.decimals));
        canvas.line({x_px, inner.top_px}, {x_px, bottom_px}, light_grey, 1.0);
    }
}

void Axes::draw_texts(Canvas& canvas, const Frame& frame) const {
    const Box& inner = frame.inner;
    const double right_px = inner.left_px + inner.width_px;
    const double bottom_px = inner.top_px + inner.height_px;
    canvas.path({{inner.left_px, inner.top_px},
                 {right_px, inner.top_px},
                 {right_px, bottom_px},
                 {inner.left_px, bottom_px},
                 {inner.left_px, inner.top_px}},
                grey, 1.0);
    const double middle_px = inner.left_px + inner.width_px / 2.0;
    canvas.text({middle_px, frame.outer.top_px + 1.2 * title_height_px}, title_, title_height_px);
    canvas.text({middle_px, bottom_px + gap_px + 2.0 * tick_height_px + 0.8 * label_height_px}, x_label_,
                label_height_px);
    if (!y_label_.empty()) {
        canvas.upright_text({frame.outer.left_px + 1.3 * label_height_px, inner.top_px + inner.height_px / 2.0},
                            y_label_, label_height_px);
    }
}

void Axes::draw_legend(Canvas& canvas, const Frame& frame) const {
    double y_px = frame.inner.top_px - legend_row_px * (static_cast<double>(frame.legend_rows.size()) - 0.4);
    for (const auto& row : frame.legend_rows) {
        double x_px = frame.inner.left_px;
        for (const LegendEntry& entry : row) {
            canvas.line({x_px, y_px}, {x_px + swatch_width_px, y_px}, entry.colour, 3.0);
            canvas.text({x_px + swatch_width_px + gap_px, y_px}, entry.label, label_height_px, Anchor::left);
            x_px += entry_width_px(entry.label);
        }
        y_px += legend_row_px;
    }
}

void Axes::draw_colour_bar(Canvas& canvas, const Frame& frame) const {
    if (!colour_bar_) {
        return;
    }
    const double left_px = frame.inner.left_px + frame.inner.width_px + 2.0 * gap_px;
    const double height_px = frame.inner.height_px;
    constexpr int steps = 100;
    for (int step = 0; step < steps; ++step) {
        const double top_px = frame.inner.top_px + height_px * (1.0 - (step + 1.0) / steps);
        canvas.fill({left_px, top_px, colour_bar_width_px, height_px / steps + 1.0}, heat_colour((step + 0.5) / steps));
    }
    const double high = std::max(colour_bar_->high, 1e-12);
    const Ticks ticks = nice_ticks(0.0, high, ticks_that_fit(height_px, y_tick_spacing_px));
    for (const double place : ticks.places) {
        canvas.text({left_px + colour_bar_width_px + gap_px, frame.inner.top_px + height_px * (1.0 - place / high)},
                    tick_text(place, ticks.decimals), tick_height_px, Anchor::left);
    }
    canvas.upright_text(
        {frame.outer.left_px + frame.outer.width_px - 1.3 * label_height_px, frame.inner.top_px + height_px / 2.0},
        colour_bar_->label, label_height_px);
}

}  // namespace ddtool::report

#include "study/compare/side_by_side.hpp"

#include <algorithm>

namespace ddtool::compare {
namespace {

constexpr double page_width_px = 1500.0;
constexpr double margins_px = 90.0;  ///< of a panel: title, ticks, label

std::size_t columns_for(const Extent& extent, std::size_t panels) {
    const double aspect = extent.x.length() / std::max(extent.y.length(), 1e-9);
    const std::size_t most = aspect > 5.0 ? 1 : aspect > 2.0 ? 2 : 4;
    return std::min(panels, most);
}

}  // namespace

void write_side_by_side(const std::filesystem::path& file, const Extent& extent, std::size_t panels,
                        const std::function<void(plot::Axes& axes, std::size_t panel)>& draw) {
    const std::size_t columns = columns_for(extent, panels);
    const std::size_t rows = (panels + columns - 1) / columns;
    const double inner_width_px = page_width_px / static_cast<double>(columns) - margins_px;
    const double inner_height_px =
        std::clamp(inner_width_px * extent.y.length() / std::max(extent.x.length(), 1e-9), 90.0, 900.0);
    plot::Figure figure({.width_px = page_width_px,
                         .height_px = static_cast<double>(rows) * (inner_height_px + margins_px),
                         .row_shares = std::vector<double>(rows, 1.0),
                         .columns = columns});
    for (std::size_t panel = 0; panel < panels; ++panel) {
        plot::Axes& axes = figure.axes(panel / columns, panel % columns);
        axes.x_label("x [m]").y_label("y [m]").equal_aspect();
        axes.x_range(extent.x.low, extent.x.high).y_range(extent.y.low, extent.y.high);
        draw(axes, panel);
    }
    figure.write_png(file);
}

}  // namespace ddtool::compare

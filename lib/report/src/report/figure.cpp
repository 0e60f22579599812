#include "report/figure.hpp"

#include <numeric>
#include <utility>

namespace ddtool::report {

Figure::Figure(FigureLayout layout) : layout_(std::move(layout)), axes_(layout_.row_shares.size() * layout_.columns) {}

Axes& Figure::axes(std::size_t row, std::size_t column) {
    std::optional<Axes>& place = axes_.at(row * layout_.columns + column);
    if (!place) {
        place.emplace();
    }
    return *place;
}

cv::Mat3b Figure::render() const {
    Canvas canvas(layout_.width_px, layout_.height_px);
    const double shares = std::accumulate(layout_.row_shares.begin(), layout_.row_shares.end(), 0.0);
    const double width_px = layout_.width_px / static_cast<double>(layout_.columns);
    Box box{0.0, 0.0, width_px, 0.0};
    for (std::size_t row = 0; row < layout_.row_shares.size(); ++row) {
        box.height_px = layout_.height_px * layout_.row_shares[row] / shares;
        for (std::size_t column = 0; column < layout_.columns; ++column) {
            box.left_px = width_px * static_cast<double>(column);
            if (const std::optional<Axes>& axes = axes_[row * layout_.columns + column]) {
                axes->draw(canvas, box);
            }
        }
        box.top_px += box.height_px;
    }
    return canvas.page();
}

void Figure::write_png(const std::filesystem::path& path) const {
    const cv::Mat3b page = render();
    ddtool::write_png(path, pixels_of(page));
}

}  // namespace ddtool::report

#include "report/colour.hpp"

#include <algorithm>
#include <array>
#include <opencv2/imgproc.hpp>

namespace ddtool::report {

Colour series_colour(std::size_t index) {
    static constexpr std::array<Colour, 7> colours{
        {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}, {86, 180, 233}, {90, 90, 90}}};
    return colours[index % colours.size()];
}

Colour heat_colour(double fraction) {
    static const cv::Mat3b table = [] {
        cv::Mat1b levels(1, 256);
        for (int level = 0; level < levels.cols; ++level) {
            levels(0, level) = static_cast<std::uint8_t>(level);
        }
        cv::Mat3b colours;
        cv::applyColorMap(levels, colours, cv::COLORMAP_PLASMA);
        return colours;
    }();
    constexpr double last_level = 215.0;  // the colours above this level are yellow, which is hard to see on white
    const cv::Vec3b bgr = table(0, static_cast<int>(last_level * std::clamp(fraction, 0.0, 1.0)));
    return {bgr[2], bgr[1], bgr[0]};
}

}  // namespace ddtool::report

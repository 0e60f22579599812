#include "study/judge/confusion_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/canvas.hpp"
#include "system/png_file.hpp"

namespace ddtool::detection {
namespace {

constexpr std::size_t columns = 3;
constexpr double panel_width_px = 480.0;
constexpr double panel_height_px = 300.0;
constexpr double field_width_px = 165.0;
constexpr double field_height_px = 90.0;
constexpr double left_px = 115.0;
constexpr double top_px = 60.0;
constexpr double text_px = 9.0;

/// Light to blue; dark enough for white text from one half on.
plot::Colour shade(double share) {
    const auto fade = [&](double to) { return static_cast<std::uint8_t>(std::lround(245.0 + (to - 245.0) * share)); };
    return {fade(20.0), fade(80.0), fade(160.0)};
}

void draw_field(plot::Canvas& canvas, const plot::Box& box, std::uint64_t count, std::uint64_t of_class) {
    const double share = of_class == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(of_class);
    canvas.fill(box, shade(share));
    const plot::Pixel middle{box.left_px + box.width_px / 2.0, box.top_px + box.height_px / 2.0};
    const std::string text = std::to_string(count) + " (" + std::to_string(std::lround(100.0 * share)) + " %)";
    canvas.text(middle, text, text_px, plot::Anchor::centre, share > 0.5 ? plot::white : plot::black);
}

void draw_panel(plot::Canvas canvas, const Evaluation& evaluation) {
    const Confusion& confusion = evaluation.performance.confusion;
    const std::array<std::array<std::uint64_t, 2>, 2> counts{
        {{confusion.true_positives, confusion.false_negatives}, {confusion.false_positives, confusion.true_negatives}}};
    constexpr std::array<const char*, 2> names{"degenerate", "not degenerate"};
    const Detector& detector = evaluation.detector;
    canvas.text({left_px + field_width_px, 16.0}, detector.name + " (" + detector.swarm + ")", text_px);
    for (std::size_t row = 0; row < 2; ++row) {
        const double y_px = top_px + static_cast<double>(row) * field_height_px;
        canvas.text({left_px - 8.0, y_px + field_height_px / 2.0}, names[row], text_px, plot::Anchor::right);
        for (std::size_t column = 0; column < 2; ++column) {
            const double x_px = left_px + static_cast<double>(column) * field_width_px;
            draw_field(canvas, {x_px, y_px, field_width_px, field_height_px}, counts[row][column],
                       counts[row][0] + counts[row][1]);
        }
    }
    for (std::size_t column = 0; column < 2; ++column) {
        canvas.text({left_px + (static_cast<double>(column) + 0.5) * field_width_px, top_px - 14.0},
                    std::string("decided ") + names[column], text_px);
    }
}

}  // namespace

void draw_confusions(const std::filesystem::path& file, std::span<const Evaluation> evaluations) {
    std::vector<const Evaluation*> deciding;
    for (const Evaluation& evaluation : evaluations) {
        if (evaluation.performance.confusion.count() > 0) {
            deciding.push_back(&evaluation);
        }
    }
    const std::size_t rows = std::max<std::size_t>(1, (deciding.size() + columns - 1) / columns);
    plot::Canvas page(panel_width_px * static_cast<double>(columns), panel_height_px * static_cast<double>(rows));
    for (std::size_t index = 0; index < deciding.size(); ++index) {
        const std::size_t row = index / columns;
        const std::size_t column = index % columns;
        const plot::Box box{static_cast<double>(column) * panel_width_px, static_cast<double>(row) * panel_height_px,
                            panel_width_px, panel_height_px};
        draw_panel(page.window(box), *deciding[index]);
    }
    const cv::Mat3b pixels = page.page();
    write_png(file, pixels_of(pixels));
}

}  // namespace ddtool::detection

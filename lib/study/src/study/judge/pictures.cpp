#include "study/judge/pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "report/canvas.hpp"
#include "report/figure.hpp"
#include "scores/rank_statistics.hpp"
#include "study/judge/mistakes.hpp"
#include "study/judge/samples.hpp"
#include "system/folder.hpp"
#include "system/png_file.hpp"

namespace ddtool::judge {
namespace {

constexpr std::size_t columns = 3;
constexpr double panel_width_px = 480.0;
constexpr double panel_height_px = 300.0;
constexpr double field_width_px = 165.0;
constexpr double field_height_px = 90.0;
constexpr double left_px = 115.0;
constexpr double top_px = 60.0;
constexpr double text_px = 9.0;

/// A colour from light grey (0) to blue (1). From one half on it is dark enough for white text.
report::Colour shade(double share) {
    const auto fade = [&](double to) { return static_cast<std::uint8_t>(std::lround(245.0 + (to - 245.0) * share)); };
    return {fade(20.0), fade(80.0), fade(160.0)};
}

void draw_field(report::Canvas& canvas, const report::Box& box, std::uint64_t count, std::uint64_t of_class) {
    const double share = of_class == 0 ? 0.0 : static_cast<double>(count) / static_cast<double>(of_class);
    canvas.fill(box, shade(share));
    const report::Pixel middle{box.left_px + box.width_px / 2.0, box.top_px + box.height_px / 2.0};
    const std::string text = std::to_string(count) + " (" + std::to_string(std::lround(100.0 * share)) + " %)";
    canvas.text(middle, text, text_px, report::Anchor::centre, share > 0.5 ? report::white : report::black);
}

void draw_panel(report::Canvas canvas, const Evaluation& evaluation) {
    const Confusion& confusion = evaluation.performance.confusion;
    const std::array<std::array<std::uint64_t, 2>, 2> counts{
        {{confusion.true_positives, confusion.false_negatives}, {confusion.false_positives, confusion.true_negatives}}};
    constexpr std::array<const char*, 2> names{"degenerate", "not degenerate"};
    const Detector& detector = evaluation.detector;
    canvas.text({left_px + field_width_px, 16.0}, detector.name + " (" + detector.swarm + ")", text_px);
    for (std::size_t row = 0; row < 2; ++row) {
        const double y_px = top_px + static_cast<double>(row) * field_height_px;
        canvas.text({left_px - 8.0, y_px + field_height_px / 2.0}, names[row], text_px, report::Anchor::right);
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

/// Draws a confusion matrix of four fields for every detector that decides. The rows are the true classes and the
/// columns the decisions. A field is the darker, the larger its share of the samples of the row is.
void draw_confusions(const std::filesystem::path& file, std::span<const Evaluation> evaluations) {
    std::vector<const Evaluation*> deciding;
    for (const Evaluation& evaluation : evaluations) {
        if (evaluation.performance.confusion.count() > 0) {
            deciding.push_back(&evaluation);
        }
    }
    const std::size_t rows = std::max<std::size_t>(1, (deciding.size() + columns - 1) / columns);
    report::Canvas page(panel_width_px * static_cast<double>(columns), panel_height_px * static_cast<double>(rows));
    for (std::size_t index = 0; index < deciding.size(); ++index) {
        const std::size_t row = index / columns;
        const std::size_t column = index % columns;
        const report::Box box{static_cast<double>(column) * panel_width_px, static_cast<double>(row) * panel_height_px,
                              panel_width_px, panel_height_px};
        draw_panel(page.window(box), *deciding[index]);
    }
    const cv::Mat3b pixels = page.page();
    write_png(file, pixels_of(pixels));
}

std::string legend(const Detector& detector) {
    const std::string seed = detector.seed ? " seed " + std::to_string(*detector.seed) : "";
    return detector.name + " (" + detector.swarm + ")" + seed;
}

using Drawn = std::vector<const Evaluation*>;

/// The evaluations that are drawn: as many as there are colours, models first, then by falling AUC.
Drawn most_telling(std::span<const Evaluation> evaluations) {
    constexpr std::size_t colours = 7;
    Drawn drawn;
    for (const Evaluation& evaluation : evaluations) {
        drawn.push_back(&evaluation);
    }
    const auto rank = [](const Evaluation* each) {
        return std::pair(each->detector.is_model() ? 0 : 1, -each->performance.auc);
    };
    std::stable_sort(drawn.begin(), drawn.end(), [&](auto* a, auto* b) { return rank(a) < rank(b); });
    drawn.resize(std::min(drawn.size(), colours));
    return drawn;
}

void draw_roc(const std::filesystem::path& file, const Drawn& evaluations) {
    report::Figure figure({.width_px = 900.0, .height_px = 900.0});
    report::Axes& axes = figure.axes();
    axes.title("ROC").x_label("false positive rate").y_label("true positive rate");
    axes.x_range(0.0, 1.0).y_range(0.0, 1.0);
    std::size_t colour = 0;
    for (const Evaluation* evaluation : evaluations) {
        std::vector<double> x;
        std::vector<double> y;
        for (const RocPoint& point : roc_curve(evaluation->scores, evaluation->samples.degenerate)) {
            x.push_back(point.false_positive_rate);
            y.push_back(point.true_positive_rate);
        }
        axes.line(x, y, {.label = legend(evaluation->detector), .colour = report::series_colour(colour++)});
    }
    figure.write_png(file);
}

void draw_reliability(const std::filesystem::path& file, std::span<const Evaluation> evaluations) {
    report::Figure figure({.width_px = 900.0, .height_px = 900.0});
    report::Axes& axes = figure.axes();
    axes.title("Reliability").x_label("mean degree").y_label("share that is degenerate");
    axes.x_range(0.0, 1.0).y_range(0.0, 1.0);
    const std::vector<double> corner{0.0, 1.0};
    axes.line(corner, corner, {.label = "calibrated", .colour = report::grey});
    std::size_t colour = 0;
    for (const Evaluation& evaluation : evaluations) {
        if (!evaluation.calibration) {
            continue;
        }
        std::vector<double> said;
        std::vector<double> was;
        for (const ReliabilityBin& bin : evaluation.calibration->bins) {
            if (bin.count > 0) {
                said.push_back(bin.mean_probability);
                was.push_back(bin.positive_share);
            }
        }
        const report::Colour own = report::series_colour(colour++);
        axes.line(said, was, {.label = legend(evaluation.detector), .colour = own});
        axes.scatter(said, was, {.label = "", .colour = own, .width_px = 6.0});
    }
    figure.write_png(file);
}

const dataset::Grouping& by_particles() { return dataset::groupings().back(); }

void draw_particles(const std::filesystem::path& file, const dataset::Dataset& data, const Drawn& evaluations) {
    report::Figure figure;
    report::Axes& axes = figure.axes();
    axes.title("Accuracy by number of particles").x_label("log10 of the number of particles").y_label("accuracy");
    std::size_t colour = 0;
    for (const Evaluation* evaluation : evaluations) {
        std::vector<double> particles;
        std::vector<double> accuracy;
        for (const auto& [key, places] : grouped(data, evaluation->samples, by_particles())) {
            particles.push_back(std::log10(key.number));
            accuracy.push_back(performance_at(*evaluation, places).confusion.accuracy());
        }
        axes.line(particles, accuracy,
                  {.label = legend(evaluation->detector), .colour = report::series_colour(colour++)});
    }
    figure.write_png(file);
}

}  // namespace

void draw_evaluations(const std::filesystem::path& folder, const dataset::Dataset& data,
                      std::span<const Evaluation> evaluations, const Evaluation& shown) {
    made_folder(folder);
    draw_roc(folder / "roc.png", most_telling(evaluations));
    draw_reliability(folder / "reliability.png", evaluations);
    draw_confusions(folder / "confusion.png", evaluations);
    draw_particles(folder / "particles.png", data, most_telling(evaluations));
    draw_mistakes(folder / "mistakes.png", data, shown);
}

}  // namespace ddtool::judge

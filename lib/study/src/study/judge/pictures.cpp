#include "study/judge/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "report/figure.hpp"
#include "scores/ranks.hpp"
#include "study/judge/confusion_picture.hpp"
#include "study/judge/groups.hpp"
#include "study/judge/mistakes.hpp"
#include "system/folder.hpp"

namespace ddtool::detection {
namespace {

std::string legend(const Detector& detector) {
    const std::string seed = detector.seed ? " seed " + std::to_string(*detector.seed) : "";
    return detector.name + " (" + detector.swarm + ")" + seed;
}

using Drawn = std::vector<const Evaluation*>;

/// As many as there are colours: models first, then the higher AUC.
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
    plot::Figure figure({.width_px = 900.0, .height_px = 900.0});
    plot::Axes& axes = figure.axes();
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
        axes.line(x, y, {.label = legend(evaluation->detector), .colour = plot::series_colour(colour++)});
    }
    figure.write_png(file);
}

void draw_reliability(const std::filesystem::path& file, std::span<const Evaluation> evaluations) {
    plot::Figure figure({.width_px = 900.0, .height_px = 900.0});
    plot::Axes& axes = figure.axes();
    axes.title("Reliability").x_label("mean degree").y_label("share that is degenerate");
    axes.x_range(0.0, 1.0).y_range(0.0, 1.0);
    const std::vector<double> corner{0.0, 1.0};
    axes.line(corner, corner, {.label = "calibrated", .colour = plot::grey});
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
        const plot::Colour own = plot::series_colour(colour++);
        axes.line(said, was, {.label = legend(evaluation.detector), .colour = own});
        axes.scatter(said, was, {.label = "", .colour = own, .width_px = 6.0});
    }
    figure.write_png(file);
}

const dataset::Grouping& by_particles() { return dataset::groupings().back(); }

void draw_particles(const std::filesystem::path& file, const dataset::Dataset& data, const Drawn& evaluations) {
    plot::Figure figure;
    plot::Axes& axes = figure.axes();
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
                  {.label = legend(evaluation->detector), .colour = plot::series_colour(colour++)});
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

}  // namespace ddtool::detection

#include "dataset/histograms.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "dataset/build_settings.hpp"
#include "dataset/description.hpp"
#include "dataset/grouping.hpp"
#include "report/figure.hpp"
#include "system/folder.hpp"

namespace ddtool::dataset {
namespace {

constexpr std::size_t columns = 3;
constexpr std::size_t bins = 40;
constexpr double least_log = -3.0;  ///< what is beyond is counted at the end, 0 and infinity too
constexpr double most_log = 3.0;

struct FamilyValues {
    std::vector<double> logs;
    std::size_t degenerate = 0;
};

std::map<std::string, FamilyValues> by_family(const Dataset& data, LabelRule rule, const auto& value_of) {
    std::map<std::string, FamilyValues> families;
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        if (sample.label_of(rule) != Label::unknown) {
            FamilyValues& family = families[scene_family(data.run_of(sample))];
            family.logs.push_back(std::clamp(std::log10(value_of(sample)), least_log, most_log));
            family.degenerate += sample.label_of(rule) == Label::degenerate ? 1U : 0U;
        }
    }
    return families;
}

std::string title_of(const std::string& family, const FamilyValues& values) {
    const double share = static_cast<double>(values.degenerate) / static_cast<double>(values.logs.size());
    return family + ": " + std::to_string(std::lround(100.0 * share)) + " % of " + std::to_string(values.logs.size()) +
           " degenerate";
}

void draw(const std::filesystem::path& file, const std::map<std::string, FamilyValues>& families,
          const std::string& x_label, double threshold) {
    const std::size_t rows = std::max<std::size_t>(1, (families.size() + columns - 1) / columns);
    plot::Figure figure({.width_px = 1400.0,
                         .height_px = 260.0 * static_cast<double>(rows),
                         .row_shares = std::vector<double>(rows, 1.0),
                         .columns = columns});
    std::size_t place = 0;
    for (const auto& [family, values] : families) {
        const std::vector<double> at(2, std::log10(threshold));
        figure.axes(place / columns, place % columns)
            .title(title_of(family, values))
            .x_label(x_label)
            .x_range(least_log, most_log)
            .histogram(values.logs, bins)
            .line(at, std::vector{0.0, static_cast<double>(values.logs.size()) / 10.0},
                  {.label = "threshold", .colour = plot::series_colour(1)});
        ++place;
    }
    figure.write_png(file);
}

}  // namespace

void draw_histograms(const std::filesystem::path& folder, const Dataset& data) {
    const LabelSettings labels = assembly_from_json(data.manifest().settings).labels;
    made_folder(folder);
    draw(folder / "dispersion.png",
         by_family(data, LabelRule::dispersion,
                   [&](const SampleRecord& sample) { return labelled_dispersion(sample.dispersion, labels); }),
         "log10 R of " + labels.dispersion_weight, labels.dispersion_threshold);
    draw(folder / "fisher.png", by_family(data, LabelRule::fisher, physical_ratio), "log10 (weak sd / odometry sd)",
         labels.fisher_ratio);
}

}  // namespace ddtool::dataset

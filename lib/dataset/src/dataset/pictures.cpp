#include "dataset/pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>

#include "dataset/build_settings.hpp"
#include "dataset/description.hpp"
#include "dataset/grouping.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "report/figure.hpp"
#include "report/montage.hpp"
#include "system/folder.hpp"
#include "system/png_file.hpp"

namespace ddtool::dataset {
namespace {

constexpr std::size_t histogram_columns = 3;
constexpr std::size_t bins = 40;
/// values beyond these limits, including 0 and infinity, are counted in the first or the last bin
constexpr double least_log = -3.0;
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

std::string family_title(const std::string& family, const FamilyValues& values) {
    const double share = static_cast<double>(values.degenerate) / static_cast<double>(values.logs.size());
    return family + ": " + std::to_string(std::lround(100.0 * share)) + " % of " + std::to_string(values.logs.size()) +
           " degenerate";
}

void draw_families(const std::filesystem::path& file, const std::map<std::string, FamilyValues>& families,
                   const std::string& x_label, double threshold) {
    const std::size_t rows = std::max<std::size_t>(1, (families.size() + histogram_columns - 1) / histogram_columns);
    report::Figure figure({.width_px = 1400.0,
                           .height_px = 260.0 * static_cast<double>(rows),
                           .row_shares = std::vector<double>(rows, 1.0),
                           .columns = histogram_columns});
    std::size_t place = 0;
    for (const auto& [family, values] : families) {
        const std::vector<double> at(2, std::log10(threshold));
        figure.axes(place / histogram_columns, place % histogram_columns)
            .title(family_title(family, values))
            .x_label(x_label)
            .x_range(least_log, most_log)
            .histogram(values.logs, bins)
            .line(at, std::vector{0.0, static_cast<double>(values.logs.size()) / 10.0},
                  {.label = "threshold", .colour = report::series_colour(1)});
        ++place;
    }
    figure.write_png(file);
}

constexpr std::size_t tiles = 6;  ///< for each class, in one row
constexpr double tile_px = 112.0;

using Indices = std::vector<std::size_t>;
using ByClass = std::array<Indices, 2>;

/// The used samples of both classes, for each family of scenes.
std::map<std::string, ByClass> used_samples(const Dataset& data, LabelRule rule) {
    std::map<std::string, ByClass> families;
    for (std::size_t index = 0; index < data.size(); ++index) {
        const SampleRecord& sample = data.sample(index);
        if (sample.part_of(rule, Split::paper) != Part::unused && sample.label_of(rule) != Label::unknown) {
            families[scene_family(data.run_of(sample))][index_of(sample.label_of(rule))].push_back(index);
        }
    }
    return families;
}

std::vector<cv::Mat> drawn(const Dataset& data, const Indices& samples, ParticleRenderer& renderer) {
    std::vector<cv::Mat> pictures;
    const auto size_px = static_cast<int>(renderer.settings().size_px);
    for (std::size_t tile = 0; tile < std::min(tiles, samples.size()); ++tile) {
        cv::Mat1b picture(size_px, size_px);
        const std::size_t sample = samples[tile * samples.size() / std::min(tiles, samples.size())];
        renderer.render(data.particles(sample), std::span<std::uint8_t>(picture.data, picture.total()));
        pictures.push_back(picture);
    }
    return pictures;
}

void draw_montage(const std::filesystem::path& file, const Dataset& data, LabelRule rule,
                  const ImageSettings& settings) {
    ParticleRenderer renderer(settings);
    std::vector<report::MontageRow> rows;
    for (const auto& [family, samples] : used_samples(data, rule)) {
        rows.push_back({family, {drawn(data, samples[1], renderer), drawn(data, samples[0], renderer)}});
    }
    const cv::Mat3b page = report::montage({class_names[1], class_names[0]}, rows, tile_px);
    write_png(file, pixels_of(page));
}

}  // namespace

void draw_histograms(const std::filesystem::path& folder, const Dataset& data) {
    const LabelSettings labels = assembly_from_json(data.manifest().settings).labels;
    made_folder(folder);
    draw_families(folder / "dispersion.png",
                  by_family(data, LabelRule::dispersion,
                            [&](const SampleRecord& sample) { return labelled_dispersion(sample.dispersion, labels); }),
                  "log10 R of " + labels.dispersion_weight, labels.dispersion_threshold);
    draw_families(folder / "fisher.png", by_family(data, LabelRule::fisher, physical_ratio),
                  "log10 (weak sd / odometry sd)", labels.fisher_ratio);
}

std::string montage_name(LabelRule rule, Swarm swarm) {
    return std::string("montage-") + label_rule_names[index_of(rule)] + "-" + swarm_names[index_of(swarm)] + ".png";
}

void draw_montages(const std::filesystem::path& folder, const Dataset& data, const ImageSettings& settings) {
    made_folder(folder);
    for (const LabelRule rule : all_label_rules) {
        for (const Swarm swarm : {Swarm::absolute, Swarm::step, Swarm::response}) {
            ImageSettings of_swarm = settings;
            of_swarm.swarm = swarm;
            draw_montage(folder / montage_name(rule, swarm), data, rule, of_swarm);
        }
    }
}

}  // namespace ddtool::dataset

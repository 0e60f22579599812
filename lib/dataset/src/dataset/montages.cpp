#include "dataset/montages.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <opencv2/core.hpp>

#include "dataset/grouping.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "report/montage.hpp"
#include "system/folder.hpp"
#include "system/png_file.hpp"

namespace ddtool::dataset {
namespace {

constexpr std::size_t tiles = 6;  ///< of a class in a row
constexpr double tile_px = 112.0;

using Indices = std::vector<std::size_t>;
using ByClass = std::array<Indices, 2>;

/// Used samples of both classes, family by family.
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

std::vector<cv::Mat> drawn_samples(const Dataset& data, const Indices& samples, ParticleRenderer& renderer) {
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
    std::vector<plot::MontageRow> rows;
    for (const auto& [family, samples] : used_samples(data, rule)) {
        rows.push_back(
            {family, {drawn_samples(data, samples[1], renderer), drawn_samples(data, samples[0], renderer)}});
    }
    const cv::Mat3b page = plot::montage({class_names[1], class_names[0]}, rows, tile_px);
    write_png(file, pixels_of(page));
}

}  // namespace

std::string montage_name(LabelRule rule, Swarm swarm) {
    return std::string("montage-") + label_rule_names[index_of(rule)] + "-" + Json(swarm).get<std::string>() + ".png";
}

void draw_montages(const std::filesystem::path& folder, const Dataset& data, const ImageSettings& settings) {
    made_folder(folder);
    for (const LabelRule rule : {LabelRule::dispersion, LabelRule::fisher}) {
        for (const Swarm swarm : {Swarm::absolute, Swarm::step, Swarm::response}) {
            ImageSettings of_swarm = settings;
            of_swarm.swarm = swarm;
            draw_montage(folder / montage_name(rule, swarm), data, rule, of_swarm);
        }
    }
}

}  // namespace ddtool::dataset

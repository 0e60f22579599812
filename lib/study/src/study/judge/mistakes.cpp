#include "study/judge/mistakes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <opencv2/core.hpp>

#include "dataset/grouping.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "report/montage.hpp"
#include "system/png_file.hpp"

namespace ddtool::judge {
namespace {

constexpr std::size_t tiles = 6;  ///< for each kind of mistake, in one row
constexpr double tile_px = 112.0;

/// The mistakes in all scenes of one family.
struct Family {
    std::array<std::size_t, 2> count{};  ///< missed samples and false alarms
    std::array<std::vector<cv::Mat>, 2> worst;
};

cv::Mat drawn(ParticleRenderer& renderer, Particles swarm) {
    const auto size_px = static_cast<int>(renderer.settings().size_px);
    cv::Mat1b picture(size_px, size_px);
    renderer.render(swarm, std::span<std::uint8_t>(picture.data, picture.total()));
    return picture;
}

std::string caption_of(const std::string& name, const Family& family) {
    return name + ": " + std::to_string(family.count[0]) + " missed, " + std::to_string(family.count[1]) +
           " false alarms";
}

}  // namespace

std::vector<std::size_t> mistakes_of(const Evaluation& evaluation, bool degenerate) {
    const double threshold = evaluation.detector.threshold;
    std::vector<std::size_t> places;
    if (std::isnan(threshold)) {
        return places;
    }
    for (std::size_t place = 0; place < evaluation.scores.size(); ++place) {
        const bool decided = evaluation.scores[place] > threshold;
        if (evaluation.samples.degenerate[place] == degenerate && decided != degenerate) {
            places.push_back(place);
        }
    }
    const auto distance = [&](std::size_t place) { return std::abs(evaluation.scores[place] - threshold); };
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return distance(a) > distance(b); });
    return places;
}

void draw_mistakes(const std::filesystem::path& file, const dataset::Dataset& data, const Evaluation& evaluation) {
    ParticleRenderer renderer(evaluation.detector.image);
    std::map<std::string, Family> families;
    for (const std::size_t kind : {0U, 1U}) {
        for (const std::size_t place : mistakes_of(evaluation, kind == 0)) {
            const std::size_t sample = evaluation.samples.indices[place];
            Family& family = families[dataset::scene_family(data.run_of(data.sample(sample)))];
            ++family.count[kind];
            if (family.worst[kind].size() < tiles) {
                family.worst[kind].push_back(drawn(renderer, data.particles(sample)));
            }
        }
    }
    std::vector<report::MontageRow> rows;
    rows.reserve(families.size());
    for (const auto& [name, family] : families) {
        rows.push_back({caption_of(name, family), {family.worst[0], family.worst[1]}});
    }
    write_png(file, pixels_of(report::montage({"missed: degenerate", "false alarms: not degenerate"}, rows, tile_px)));
}

}  // namespace ddtool::judge

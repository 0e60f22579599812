#include "study/compare/world_pictures.hpp"

#include "base/pattern.hpp"
#include "ddtool/base/error.hpp"
#include "study/compare/run_pictures.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"

namespace ddtool::compare {
namespace {

std::vector<Picture> draw_world(const std::filesystem::path& folder, const ShownRun& run) {
    const std::string about = run.world + ", seed " + std::to_string(run.seed) + ": ";
    const std::string stem = "pictures/" + file_name_of(run.world);
    std::vector<Picture> pictures;
    if (run.estimates.empty()) {
        return pictures;
    }
    pictures.push_back({about + "trajectories", stem + "-trajectories.png"});
    draw_trajectories(folder / pictures.back().file, run);
    pictures.push_back({about + "maps", stem + "-maps.png"});
    draw_maps(folder / pictures.back().file, run);
    if (!run.truth.empty()) {
        pictures.push_back({about + "errors over time", stem + "-errors.png"});
        draw_errors(folder / pictures.back().file, run);
    }
    return pictures;
}

}  // namespace

std::vector<Picture> draw_worlds(const std::filesystem::path& folder, const Experiment& experiment,
                                 const std::vector<Cell>& cells, const std::vector<CellResult>& results,
                                 const ResultStore& store, ThreadPool& threads) {
    made_folder(folder / "pictures");
    const std::vector<Summary> summaries = summaries_of(experiment, cells, results);
    std::vector<std::vector<Picture>> by_world(experiment.worlds.size());
    threads.for_each(experiment.worlds.size(), [&](std::size_t world, std::size_t /*worker*/) {
        try {
            const std::size_t seed = median_seed(experiment, summaries, world);
            by_world[world] = draw_world(folder, shown_run(experiment, cells, results, store, world, seed));
        } catch (const Error& error) {
            log_warning("pictures of " + experiment.worlds[world].name() + ": " + error.what());
        }
    });
    std::vector<Picture> pictures;
    for (const std::vector<Picture>& of_world : by_world) {
        pictures.insert(pictures.end(), of_world.begin(), of_world.end());
    }
    return pictures;
}

}  // namespace ddtool::compare

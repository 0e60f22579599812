#include "train/recipes.hpp"

#include "train/train_settings.hpp"

namespace ddtool::train {
namespace {

/// The part of a training's settings that a recipe decides.
Json recipe_part(const TrainSettings& settings) {
    const Json whole = settings;
    return {{"model", settings.model},
            {"label", settings.label},
            {"split", settings.split},
            {"image", whole.at("image")},
            {"augmentation", whole.at("augmentation")},
            {"loss", settings.loss}};
}

Recipe recipe_of(const std::string& name, const TrainSettings& settings) {
    return {name, recipe_part(settings), {{"label", settings.label}, {"split", settings.split}}};
}

/// The paper's images show positions on a canvas of 10 m. Rotating them, mirroring them and drawing fewer particles are
/// no part of the paper.
TrainSettings paper_settings() {
    TrainSettings settings;
    settings.model = "ddmodel";
    settings.label = "dispersion";
    settings.split = "paper";
    settings.image.swarm = Swarm::absolute;
    settings.augmentation.rotate = false;
    settings.augmentation.flip = false;
    settings.augmentation.resample_particles = false;
    return settings;
}

}  // namespace

const std::vector<Recipe>& recipes() {
    // a named object, because GCC 12 warns that a temporary might be used uninitialised
    static const TrainSettings defaults;
    static const std::vector<Recipe> table{recipe_of(best_recipe_name, defaults), recipe_of("paper", paper_settings())};
    return table;
}

}  // namespace ddtool::train

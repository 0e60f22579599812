#include "train/recipes.hpp"

#include <gtest/gtest.h>

#include "train/train_settings.hpp"

namespace ddtool::train {
namespace {

TrainSettings settings_by(const Recipe& recipe) {
    const TrainSettings defaults;
    Json json = defaults;
    merge_settings(json, recipe.training, recipe.name);
    return train_settings_from_json(json);
}

TEST(Recipes, TheBestIsWhatTheDefaultsSay) {
    const TrainSettings defaults;
    EXPECT_EQ(recipes().front().name, best_recipe_name);
    EXPECT_EQ(Json(settings_by(recipes().front())), Json(defaults));
}

TEST(Recipes, ThePapersShowsPositionsAsTheyAreAndLearnsR) {
    const Recipe& paper = recipes().back();
    const TrainSettings settings = settings_by(paper);
    EXPECT_EQ(paper.name, "paper");
    EXPECT_EQ(settings.model, "ddmodel");
    EXPECT_EQ(label_rule_of(settings), dataset::LabelRule::dispersion);
    EXPECT_EQ(split_of(settings), dataset::Split::paper);
    EXPECT_EQ(settings.image.swarm, Swarm::absolute);
    EXPECT_EQ(settings.image.canvas_m, 10.0);
    EXPECT_FALSE(settings.augmentation.rotate || settings.augmentation.flip ||
                 settings.augmentation.resample_particles);
}

TEST(Recipes, AreTestedByTheLabelAndSplitThatTheyAreTrainedBy) {
    for (const Recipe& recipe : recipes()) {
        EXPECT_EQ(recipe.evaluation.at("label"), recipe.training.at("label")) << recipe.name;
        EXPECT_EQ(recipe.evaluation.at("split"), recipe.training.at("split")) << recipe.name;
    }
}

}  // namespace
}  // namespace ddtool::train

#pragma once

#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"

namespace ddtool::train {

/// What goes together when a network is trained: label, swarm, split, network and augmentation.
struct Recipe {
    std::string name;
    Json training;    ///< changes of the settings of a training
    Json evaluation;  ///< its label and split, which a test of the network goes by
};

inline constexpr const char* best_recipe_name = "best";

/// All recipes, the one that the defaults of TrainSettings follow first (docs/training.md).
const std::vector<Recipe>& recipes();

}  // namespace ddtool::train

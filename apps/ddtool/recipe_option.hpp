#pragma once

#include "command.hpp"
#include "train/recipes.hpp"

namespace ddtool {

/// The choice of a recipe, of which `part` is merged into the settings of the command.
inline NamedSettings recipe_choice(Json train::Recipe::*part, std::string& chosen) {
    NamedSettings choice{.groups = {}, .chosen = &chosen};
    for (const train::Recipe& recipe : train::recipes()) {
        choice.groups.emplace_back(recipe.name, recipe.*part);
    }
    return choice;
}

}  // namespace ddtool

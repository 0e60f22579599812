#pragma once

#include <filesystem>

#include "dataset/dataset.hpp"
#include "imaging/image_settings.hpp"

namespace ddtool::dataset {

/// Draws montage-RULE-SWARM.png into the folder for both label rules and both swarms: a row a family of scenes, samples
/// of each class beside each other, as the settings render them (but for the swarm).
void draw_montages(const std::filesystem::path& folder, const Dataset& data, const ImageSettings& settings);

}  // namespace ddtool::dataset

#pragma once

#include <filesystem>
#include <string>

#include "dataset/dataset.hpp"
#include "ddtool/network/image_settings.hpp"

namespace ddtool::dataset {

/// Draws dispersion.png and fisher.png into the folder. For each family of scenes they show a histogram of the quantity
/// that the label rule compares with its threshold (R or the physical ratio) on a logarithmic axis, and the share of
/// degenerate samples.
void draw_histograms(const std::filesystem::path& folder, const Dataset& data);

/// The file's name, "montage-RULE-SWARM.png".
std::string montage_name(LabelRule rule, Swarm swarm);

/// Draws montage-RULE-SWARM.png into the folder for both label rules and all swarms: one row for each family of scenes,
/// samples of each class beside each other, as the settings render them (but for the swarm).
void draw_montages(const std::filesystem::path& folder, const Dataset& data, const ImageSettings& settings);

}  // namespace ddtool::dataset

#pragma once

#include <filesystem>

#include "dataset/dataset.hpp"
#include "ddtool/network/image_settings.hpp"

namespace ddtool {

/// Prints what a data set contains, as tables or as JSON.
void print_dataset(const dataset::Dataset& data, bool as_json);

/// Draws histograms of the quantities behind the labels, and montages of the images, into the folder.
void draw_dataset(const std::filesystem::path& folder, const dataset::Dataset& data, const ImageSettings& settings);

/// Writes report.html (docs/reports.md) into the folder of a data set, with the pictures that draw_dataset() has made.
/// Returns whether the file could be written.
bool write_dataset_page(const std::filesystem::path& folder, const std::filesystem::path& pictures,
                        const dataset::Dataset& data);

}  // namespace ddtool

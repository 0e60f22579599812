#pragma once

#include <filesystem>

#include "dataset/dataset.hpp"
#include "ddtool/network/image_settings.hpp"

namespace ddtool {

/// Prints what is in a data set: tables, or JSON for machines.
void print_dataset(const dataset::Dataset& data, bool as_json);

/// Draws histograms of what the labels look at and montages of the images into the folder.
void draw_dataset(const std::filesystem::path& folder, const dataset::Dataset& data, const ImageSettings& settings);

/// Writes report.html (docs/reports.md) into a data set's folder, with the pictures that draw_dataset() made there.
/// Returns whether it could be written.
bool write_dataset_page(const std::filesystem::path& folder, const std::filesystem::path& pictures,
                        const dataset::Dataset& data);

}  // namespace ddtool

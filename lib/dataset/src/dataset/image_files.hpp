#pragma once

#include <filesystem>

#include "dataset/dataset.hpp"
#include "ddtool/base/thread_pool.hpp"
#include "ddtool/network/image_settings.hpp"

namespace ddtool::dataset {

inline constexpr const char* images_name = "images";

/// Writes every sample that is used as images/RULE/SPLIT/PART/CLASS/INDEX.png in the folder, as the paper's image data
/// set is laid out; INDEX is the sample's position in the data set. Replaces older images. Throws Error.
void write_image_files(const std::filesystem::path& folder, const Dataset& data, const ImageSettings& settings,
                       ThreadPool& threads);

}  // namespace ddtool::dataset

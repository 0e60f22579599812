#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace ddtool::plot {

/// A strip of pictures under a caption, in groups such as the classes.
struct MontageRow {
    std::string caption;
    std::vector<std::vector<cv::Mat>> groups;  ///< grey or BGR; as many groups as the montage has titles
};

/// Rows of pictures, the groups side by side under their titles. Every picture is stretched to a square of tile_px;
/// a group is as wide as its longest row, and shorter rows leave the rest white. BGR. Throws Error for a row whose
/// groups are not as many as the titles.
cv::Mat3b montage(const std::vector<std::string>& titles, const std::vector<MontageRow>& rows, double tile_px);

}  // namespace ddtool::plot

#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

namespace ddtool::report {

/// A row of pictures under a caption, in groups (such as the classes).
struct MontageRow {
    std::string caption;
    std::vector<std::vector<cv::Mat>> groups;  ///< grey or BGR; as many groups as the montage has titles
};

/// Rows of pictures, with the groups side by side under their titles. Every picture is stretched to a square of
/// tile_px. A group is as wide as its longest row; where a row is shorter, the rest stays white. BGR. Throws Error if a
/// row has another number of groups than there are titles.
cv::Mat3b montage(const std::vector<std::string>& titles, const std::vector<MontageRow>& rows, double tile_px);

}  // namespace ddtool::report

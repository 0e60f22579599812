#pragma once

#include "ddtool/network/image_settings.hpp"
#include "report/table.hpp"
#include "study/judge/evaluation.hpp"

namespace ddtool::judge {

/// How far a label is known to somebody who has understood nothing, but remembers the training samples. It tells how
/// much of a network's accuracy may be memory. One row for each way to guess, with accuracy and F1:
///
/// - the label of the training image that differs in the fewest pixels,
/// - the same, without the images of the sample's own run, among those samples for which there are others,
/// - the label of the sample before it in the same run, over the samples of all parts,
/// - always the class that is larger in the tested part.
///
/// `image` says how the images are drawn. Throws Error if the task has no samples to test or none to remember.
Table nearest_neighbour_table(const dataset::Dataset& data, const ImageSettings& image, const Task& task);

}  // namespace ddtool::judge

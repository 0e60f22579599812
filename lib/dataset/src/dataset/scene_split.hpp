#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "dataset/manifest.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// The number of samples of a scene, by label rule and class.
using SceneCounts = std::array<std::size_t, 4>;

/// Assigns a part to every scene, such that train, validation and test have as nearly as possible 6:2:2 of the samples
/// of every rule and class. Minimises the sum of the squared deviations: it places the largest scenes first, and then
/// moves and swaps scenes while that reduces the sum. The same input gives the same result.
std::vector<Part> parts_of_scenes(const std::vector<SceneCounts>& scenes);

/// Sets part[rule][held_out] of the chosen records, that is of those in a part of `paper`. All records of a scene, and
/// so of a run, get the same part, for both rules alike.
void hold_out_scenes(std::span<SampleRecord> records, const std::vector<RunEntry>& runs);

}  // namespace ddtool::dataset

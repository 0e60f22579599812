#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "dataset/manifest.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// Samples of a scene by label rule and class.
using SceneCounts = std::array<std::size_t, 4>;

/// A part for every scene, such that train, validation and test come as close as possible to 6:2:2 of the samples of
/// every rule and class at once: by the sum of squared deviations, largest scenes first, then by moving and swapping
/// scenes while that helps. The same input gives the same answer.
std::vector<Part> parts_of_scenes(const std::vector<SceneCounts>& scenes);

/// Sets part[rule][held_out] of the chosen records, those in a part of `paper`: each goes where its run's scene goes,
/// for both rules alike. No scene, and so no run, is in two parts.
void hold_out_scenes(std::span<SampleRecord> records, const std::vector<RunEntry>& runs);

}  // namespace ddtool::dataset

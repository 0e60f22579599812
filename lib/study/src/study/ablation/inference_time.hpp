#pragma once

#include <span>

#include "ddtool/network/degree_model.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::ablation {

/// Median time in milliseconds from a swarm to its degree, one swarm at a time, rendering included, after a few that do
/// not count. through_file: the image is written as PNG and read back on the way, as in the paper without its "image
/// matrix". Throws Error where the temporary folder cannot be written.
double inference_time_ms(native::DegreeModel& model, std::span<const judge::Particles> swarms, bool through_file);

}  // namespace ddtool::ablation

#pragma once

#include <span>

#include "ddtool/network/degree_model.hpp"
#include "study/judge/detector.hpp"

namespace ddtool::ablation {

/// Measures the median time in milliseconds from a swarm to its degree, including rendering, one swarm at a time, after
/// a few swarms to warm up. through_file: the image is written as a PNG file and read back, as in the paper without its
/// "image matrix". Throws Error if the temporary folder cannot be written.
double inference_time_ms(DegreeModel& model, std::span<const judge::Particles> swarms, bool through_file);

}  // namespace ddtool::ablation

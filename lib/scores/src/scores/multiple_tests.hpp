#pragma once

#include <span>
#include <vector>

namespace ddtool {

/// The p-values of a family of tests, adjusted so that the chance of even one false finding at level a is at most a,
/// whatever depends on what (Holm 1979): the smallest times the number of tests, the next times one less, never
/// falling, at most 1. In the order given.
std::vector<double> holm_adjusted(std::span<const double> p_values);

}  // namespace ddtool

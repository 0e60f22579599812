#pragma once

#include <span>
#include <vector>

namespace ddtool {

/// The p-values of a family of tests, adjusted so that the probability of even one false finding at level a is at most
/// a, however the tests depend on each other (Holm 1979): the smallest is multiplied by the number of tests, the next
/// by that number less one, and so on; the results never decrease and are at most 1. They are in the order of the
/// arguments.
std::vector<double> holm_adjusted(std::span<const double> p_values);

}  // namespace ddtool

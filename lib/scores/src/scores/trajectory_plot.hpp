#pragma once

#include "report/figure.hpp"
#include "scores/absolute_error.hpp"

namespace ddtool {

/// A figure with the aligned estimate coloured by its distance from the reference, the reference as a thin black line
/// on top, and below it the distance over time.
report::Figure ate_figure(const AteResult& result);

}  // namespace ddtool

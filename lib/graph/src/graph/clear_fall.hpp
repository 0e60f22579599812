#pragma once

namespace ddtool::graph {

/// A place fits clearly worse than another one if its log likelihood (ScanMatch::log_likelihood) is lower by this.
/// Along a bare wall, where all places fit alike, chance alone changes it by one or two.
inline constexpr double clear_fall = 8.0;

}  // namespace ddtool::graph

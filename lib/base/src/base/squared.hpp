#pragma once

namespace ddtool {

constexpr double squared(double value) { return value * value; }

}  // namespace ddtool

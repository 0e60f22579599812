#pragma once

#include <exception>
#include <string>

namespace ddtool {

/// What an exception says, as one line: ours as it is, others' up to their first line break (LibTorch adds a stack),
/// and a shortage of memory, which each library puts in its own words, in ours.
std::string failure_text(const std::exception& failure);

}  // namespace ddtool

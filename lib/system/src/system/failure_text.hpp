#pragma once

#include <exception>
#include <string>

namespace ddtool {

/// The message of an exception as one line: our own messages unchanged, those of other libraries up to the first line
/// break (LibTorch appends a stack trace), and one fixed text for a shortage of memory, which every library words
/// differently.
std::string failure_text(const std::exception& failure);

}  // namespace ddtool

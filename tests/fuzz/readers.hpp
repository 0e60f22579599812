#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>

namespace ddtool::fuzz {

/// Everything that reads bytes from outside, by name. Each takes a file's content and reads it as its command would;
/// what is wrong with it must end in ddtool::Error or a reported problem, which are no findings. Anything else is one.
using Reader = std::function<void(std::span<const char> content)>;
const std::map<std::string, Reader>& readers();

void read_message(std::span<const char> content);
void read_dataset(std::span<const char> content);

}  // namespace ddtool::fuzz

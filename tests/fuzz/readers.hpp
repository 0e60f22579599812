#pragma once

#include <functional>
#include <map>
#include <span>
#include <string>

namespace ddtool::fuzz {

/// Every reader of bytes from outside, by name. Each takes the content of a file and reads it as the command does that
/// would read such a file. A damaged content must lead to a ddtool::Error or a reported problem; anything else, such as
/// a crash or another exception, is a finding.
using Reader = std::function<void(std::span<const char> content)>;
const std::map<std::string, Reader>& readers();

void read_message(std::span<const char> content);
void read_dataset(std::span<const char> content);
void read_map_file(std::span<const char> content);
void read_map_messages(std::span<const char> content);

}  // namespace ddtool::fuzz

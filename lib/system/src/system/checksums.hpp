#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ddtool {

/// SHA-256 (FIPS 180-4) as 64 hexadecimal digits.
std::string sha256_of(std::string_view bytes);

/// Checks a file against the list SHA256SUMS (in the format of sha256sum) in the same folder. Throws Error naming the
/// file if the list has another checksum for it. A file passes if it is not listed, or if there is no list.
void expect_listed_checksum(const std::filesystem::path& file);

}  // namespace ddtool

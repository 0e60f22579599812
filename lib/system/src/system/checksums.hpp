#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace ddtool {

/// SHA-256 (FIPS 180-4) as 64 hexadecimal digits.
std::string sha256_of(std::string_view bytes);

/// Where a file SHA256SUMS (as sha256sum writes it) lies beside a file and lists it, its bytes must be those. Throws
/// Error naming the file where they are not; what is not listed may be anything.
void expect_listed_checksum(const std::filesystem::path& file);

}  // namespace ddtool

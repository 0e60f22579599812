#pragma once

#include <string>
#include <string_view>

namespace ddtool::report {

/// The bytes in base64 (RFC 4648, section 4), padded.
std::string base64(std::string_view bytes);

/// A data URI (RFC 2397) that contains the bytes of a PNG file.
std::string png_uri(std::string_view png);

}  // namespace ddtool::report

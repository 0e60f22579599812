#pragma once

#include <string>
#include <string_view>

namespace ddtool::html {

/// RFC 4648, section 4, padded.
std::string base64(std::string_view bytes);

/// A PNG file's bytes as an address that holds them (RFC 2397).
std::string png_uri(std::string_view png);

}  // namespace ddtool::html

#pragma once

#include <optional>
#include <string_view>

#include "logs/containers/compression.hpp"

namespace ddtool {

/// The name in a chunk's compression field ("" for no compression). Throws Error for a compression that MCAP does not
/// have.
std::string_view mcap_compression_name(Compression compression);
/// The compression of that name; nullopt for a name that the specification does not know.
std::optional<Compression> mcap_compression_of(std::string_view name);

}  // namespace ddtool

#pragma once

#include <optional>
#include <string_view>

#include "logs/containers/compression.hpp"

namespace ddtool {

/// The name in a chunk's compression field ("" for none). Throws Error for one that MCAP does not have.
std::string_view mcap_compression_name(Compression compression);
/// None for a name that the specification does not know.
std::optional<Compression> mcap_compression_of(std::string_view name);

}  // namespace ddtool

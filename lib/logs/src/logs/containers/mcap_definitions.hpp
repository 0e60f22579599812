#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// The schemas and channels that a file has defined so far.
class McapDefinitions {
public:
    /// Takes the content of a Schema or Channel record. Repetitions are welcome. Throws Error when it is malformed,
    /// names an unknown schema, or differs from the earlier definition of the same id (which stays).
    void add_schema(std::span<const std::byte> record);
    void add_channel(std::span<const std::byte> record);

    /// Null when there is none. The address stays valid as long as this object.
    [[nodiscard]] const McapChannel* find_channel(std::uint16_t id) const;

private:
    std::map<std::uint16_t, McapSchema> schemas_;
    std::map<std::uint16_t, McapChannel> channels_;
};

}  // namespace ddtool

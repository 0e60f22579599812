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
    /// Takes the content of a Schema or Channel record. The same definition may come again. Throws Error if the record
    /// is malformed, names an unknown schema, or differs from an earlier definition of the same id, which then stays in
    /// effect.
    void add_schema(std::span<const std::byte> record);
    void add_channel(std::span<const std::byte> record);

    /// The channel; null if it is not defined. The address stays valid as long as this object.
    [[nodiscard]] const McapChannel* find_channel(std::uint16_t id) const;

private:
    std::map<std::uint16_t, McapSchema> schemas_;
    std::map<std::uint16_t, McapChannel> channels_;
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_fields.hpp"
#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// Definitions and messages that are stored together in a log: the records of one chunk, or one record outside of all
/// chunks.
struct LogRecords {
    std::span<const std::byte> bytes;  ///< valid until the next are read
    std::uint64_t offset = 0;          ///< in the file, of the chunk or record
    bool cut_off = false;              ///< the last record may be incomplete, which has been reported
};

/// Takes the records that a section of a file provides one by one. A malformed record is reported to the section and
/// skipped.
template <typename Section>
class LogRecordWalk {
public:
    /// The message of the next record that contains one; nullopt at the end of the section.
    /// \param take reads one record from an McapFieldReader, and throws Error if the record does not end
    /// \param interpret returns the message of the record, or nullopt
    template <typename Take, typename Interpret>
    std::optional<McapMessage> next(Section& section, const Take& take, const Interpret& interpret) {
        for (;;) {
            while (!records_.bytes.empty()) {
                if (auto message = step(section, take, interpret)) {
                    return message;
                }
            }
            const auto records = section.next();
            if (!records) {
                return std::nullopt;
            }
            records_ = *records;
        }
    }

    /// The offset in the file, in bytes, of the chunk or record that is being read.
    [[nodiscard]] std::uint64_t offset() const { return records_.offset; }

private:
    template <typename Take, typename Interpret>
    std::optional<McapMessage> step(Section& section, const Take& take, const Interpret& interpret) {
        // The remaining bytes are put back only after the record has been taken to its end. If that fails, all bytes
        // after its start are lost.
        const auto before = std::exchange(records_.bytes, {});
        try {
            McapFieldReader fields(before);
            const auto record = take(fields);
            records_.bytes = fields.rest();
            return interpret(record);
        } catch (const Error& error) {
            if (!records_.cut_off || !records_.bytes.empty()) {
                section.report(records_.offset, std::string("record is skipped: ") + error.what(),
                               before.size() - records_.bytes.size());
            }
            return std::nullopt;
        }
    }

    LogRecords records_;  ///< not yet taken
};

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "logs/containers/bag_section.hpp"
#include "logs/containers/log_file.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of a ROS 1 bag (http://wiki.ros.org/Bags/Format/2.0) in the order of the file, with one chunk in memory
/// at a time. A chunk may be uncompressed, lz4 or bz2; the bag may have an index or not, and need not have been closed.
/// The encoding of the channels is "ros1", that of their schemas "ros1msg". Damage is reported to the handler, and
/// reading continues with the next record. A damaged chunk is skipped; the connections that it defined are taken from
/// the index, if there is one.
class BagReader : public MessageSource {
public:
    /// Throws Error if the file cannot be read, or if it is not a bag of version 2.0; the message says what the file
    /// looks like.
    BagReader(LogFile file, LogProblemHandler on_problem);

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override { return section_.fraction_read(); }

private:
    std::optional<McapMessage> interpret(const BagFields& header, std::span<const std::byte> data);
    std::optional<McapMessage> message_of(const BagFields& header, std::span<const std::byte> data);
    const McapChannel* find_channel(std::uint32_t connection);
    void read_index();

    LogFile file_;
    BagSection section_;
    LogRecordWalk<BagSection> records_;
    std::map<std::uint32_t, McapChannel> channels_;
    std::set<std::uint32_t> undefined_;
    bool index_read_ = false;
};

}  // namespace ddtool

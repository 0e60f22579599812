#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "logs/containers/bag_section.hpp"
#include "logs/containers/message_source.hpp"

namespace ddtool {

/// The messages of a ROS 1 bag (http://wiki.ros.org/Bags/Format/2.0) in the file's order, one chunk held at a time:
/// uncompressed, lz4 or bz2, indexed or not, closed or not. The channels' encoding is "ros1", their schemas' "ros1msg".
/// Damage goes to the handler and reading continues with the next record: a damaged chunk is skipped; connections that
/// it defined are taken from the index, where there is one.
class BagReader : public MessageSource {
public:
    /// Throws Error when the file cannot be read or is no bag of version 2.0, saying what it looks like.
    BagReader(std::filesystem::path path, LogProblemHandler on_problem);

    std::optional<McapMessage> next() override;
    [[nodiscard]] double fraction_read() const override { return section_.fraction_read(); }

private:
    std::optional<McapMessage> interpret(const BagFields& header, std::span<const std::byte> data);
    std::optional<McapMessage> message_of(const BagFields& header, std::span<const std::byte> data);
    const McapChannel* find_channel(std::uint32_t connection);
    void read_index();

    std::filesystem::path path_;
    BagSection section_;
    LogRecordWalk<BagSection> records_;
    std::map<std::uint32_t, McapChannel> channels_;
    std::set<std::uint32_t> undefined_;
    bool index_read_ = false;
};

}  // namespace ddtool

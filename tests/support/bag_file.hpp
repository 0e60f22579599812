#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "logs/containers/compression.hpp"
#include "recording.hpp"

namespace ddtool::test {

struct BagOptions {
    Compression compression = Compression::none;
    std::size_t messages_per_chunk = 10;
    bool closed =
        /// if false, the file is as a recorder leaves it that was killed: no index, and the last chunk without its
        /// length
        true;
};

/// Writes the bytes of a ROS 1 bag of format 2.0 (http://wiki.ros.org/Bags/Format/2.0).
class BagFile {
public:
    BagFile(const Recording& recording, const BagOptions& options) : options_(options) {
        bytes_ = "#ROSBAG V2.0\n" + bag_header(0);
        const std::size_t header_end = bytes_.size();
        for (std::size_t first = 0; first < recording.size(); first += options.messages_per_chunk) {
            const auto rest = std::span(recording).subspan(first);
            const bool last = rest.size() <= options.messages_per_chunk;
            add_chunk(rest.first(last ? rest.size() : options.messages_per_chunk), last && !options.closed);
        }
        if (options.closed) {
            const std::string header = bag_header(bytes_.size());
            bytes_.replace(header_end - header.size(), header.size(), header);
            for (const auto& [topic, record] : connections_) {
                bytes_ += record;
            }
        }
    }
    [[nodiscard]] const std::string& bytes() const { return bytes_; }
    /// The offset at which each chunk record begins.
    [[nodiscard]] const std::vector<std::size_t>& chunk_offsets() const { return chunk_offsets_; }

    template <typename Integer>
    static std::string raw(Integer value) {
        return {reinterpret_cast<const char*>(&value), sizeof value};
    }
    static std::string field(const std::string& name, const std::string& value) { return counted(name + "=" + value); }
    static std::string counted(const std::string& bytes) {
        return raw(static_cast<std::uint32_t>(bytes.size())) + bytes;
    }
    static std::string record(char opcode, const std::string& fields, const std::string& data) {
        return counted(field("op", {opcode}) + fields) + counted(data);
    }

private:
    static std::string bag_header(std::uint64_t index_offset) {
        return record(3,
                      field("index_pos", raw(index_offset)) + field("conn_count", raw(std::uint32_t{0})) +
                          field("chunk_count", raw(std::uint32_t{0})),
                      std::string(3900, ' '));
    }

    std::uint32_t connect(const RecordedMessage& message, std::string& chunk) {
        const auto known = ids_.find(message.topic);
        if (known != ids_.end()) {
            return known->second;
        }
        const auto id = static_cast<std::uint32_t>(ids_.size());
        ids_[message.topic] = id;
        connections_[message.topic] = record(7, field("conn", raw(id)) + field("topic", message.topic),
                                             field("topic", "/as_published") + field("type", message.ros1_type()) +
                                                 field("md5sum", "*") + field("message_definition", ""));
        chunk += connections_[message.topic];
        return id;
    }

    void add_chunk(std::span<const RecordedMessage> messages, bool left_open) {
        std::string chunk;
        for (const RecordedMessage& message : messages) {
            const std::uint32_t id = connect(message, chunk);
            const auto seconds = static_cast<std::uint32_t>(message.stamp_ns / 1'000'000'000);
            const auto nanoseconds = static_cast<std::uint32_t>(message.stamp_ns % 1'000'000'000);
            chunk += record(2, field("conn", raw(id)) + field("time", raw(seconds) + raw(nanoseconds)),
                            {reinterpret_cast<const char*>(message.ros1.data()), message.ros1.size()});
        }
        const std::vector<std::byte> stored = compress(options_.compression, std::as_bytes(std::span(chunk)));
        const std::string data(reinterpret_cast<const char*>(stored.data()), stored.size());
        const auto size = static_cast<std::uint32_t>(left_open ? 0 : chunk.size());
        const std::string fields = field("compression", name_of_compression()) + field("size", raw(size));
        chunk_offsets_.push_back(bytes_.size());
        bytes_ += left_open ? record(5, fields, "") + data : record(5, fields, data) + record(4, "", "index data");
    }

    [[nodiscard]] std::string name_of_compression() const {
        return options_.compression == Compression::lz4     ? "lz4"
               : options_.compression == Compression::bzip2 ? "bz2"
                                                            : "none";
    }

    BagOptions options_;
    std::string bytes_;
    std::map<std::string, std::uint32_t> ids_;
    std::map<std::string, std::string> connections_;
    std::vector<std::size_t> chunk_offsets_;
};

}  // namespace ddtool::test

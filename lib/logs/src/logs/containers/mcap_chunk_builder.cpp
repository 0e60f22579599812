#include "logs/containers/mcap_chunk_builder.hpp"

#include "logs/containers/mcap_compression.hpp"
#include "system/crc.hpp"

namespace ddtool {

void McapChunkBuilder::add(std::uint16_t channel, std::uint32_t sequence, std::uint64_t log_time_ns,
                           std::span<const std::byte> data) {
    messages_[channel].push_back({log_time_ns, records_.size()});
    times_.add(log_time_ns);
    McapFieldWriter fields;
    fields.put(channel).put(sequence).put(log_time_ns).put(log_time_ns);
    records_.put_record_header(McapOpcode::message, fields.size() + data.size());
    records_.put_bytes(fields.bytes()).put_bytes(data);
}

void McapChunkBuilder::write(McapOutput& output, Compression compression, McapFieldWriter& chunk_indexes) {
    const std::vector<std::byte> compressed = compress(compression, records_.bytes());
    const std::uint64_t chunk_start = output.offset();
    output.put_record(McapOpcode::chunk, McapFieldWriter()
                                             .put(times_.first())
                                             .put(times_.last())
                                             .put(std::uint64_t{records_.size()})
                                             .put(crc32_of(records_.bytes()))
                                             .put_string(mcap_compression_name(compression))
                                             .put(std::uint64_t{compressed.size()})
                                             .put_bytes(compressed));
    const std::uint64_t chunk_end = output.offset();
    McapFieldWriter index_offsets;
    for (const auto& [channel, messages] : messages_) {
        index_offsets.put(channel).put(output.offset());
        output.put_record(McapOpcode::message_index,
                          McapFieldWriter().put(channel).put_array(std::as_bytes(std::span(messages))));
    }
    chunk_indexes.put_record(McapOpcode::chunk_index, McapFieldWriter()
                                                          .put(times_.first())
                                                          .put(times_.last())
                                                          .put(chunk_start)
                                                          .put(chunk_end - chunk_start)
                                                          .put_array(index_offsets.bytes())
                                                          .put(output.offset() - chunk_end)
                                                          .put_string(mcap_compression_name(compression))
                                                          .put(std::uint64_t{compressed.size()})
                                                          .put(std::uint64_t{records_.size()}));
    *this = McapChunkBuilder();
}

}  // namespace ddtool

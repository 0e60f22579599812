#include "logs/containers/mcap_writer.hpp"

#include <array>
#include <limits>
#include <numeric>
#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr std::size_t max_ids = std::numeric_limits<std::uint16_t>::max();

std::uint16_t next_id(std::size_t taken, const char* kind) {
    if (taken == max_ids) {
        throw Error(std::string("an MCAP file holds at most ") + std::to_string(max_ids) + " " + kind);
    }
    return static_cast<std::uint16_t>(taken + 1);
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& path, McapWriterOptions options)
    : output_(path), options_(std::move(options)) {
    output_.put(mcap_magic);
    output_.put_record(McapOpcode::header, McapFieldWriter().put_string(options_.profile).put_string("ddtool"));
}

std::uint16_t McapWriter::add_schema(std::string_view name, std::string_view encoding, std::string_view data) {
    if (name.empty()) {
        return 0;
    }
    McapFieldWriter fields;
    fields.put_string(name).put_string(encoding).put_string(data);
    const auto [known, is_new] = schema_ids_.try_emplace(text_of(fields.bytes()), 0);
    if (is_new) {
        known->second = next_id(schema_ids_.size() - 1, "schemas");
        McapFieldWriter record;
        record.put_record(McapOpcode::schema, McapFieldWriter().put(known->second).put_bytes(fields.bytes()));
        output_.put(record.bytes());
        schemas_.put_bytes(record.bytes());
    }
    return known->second;
}

std::uint16_t McapWriter::add_channel(std::string_view topic, std::string_view message_encoding,
                                      std::string_view schema_name, std::string_view schema_encoding,
                                      std::string_view schema_data,
                                      const std::map<std::string, std::string>& metadata) {
    McapFieldWriter entries;
    for (const auto& [key, value] : metadata) {
        entries.put_string(key).put_string(value);
    }
    const std::uint16_t schema = add_schema(schema_name, schema_encoding, schema_data);
    const std::uint16_t id = next_id(message_counts_.size(), "channels");
    message_counts_.push_back(0);
    McapFieldWriter fields;
    fields.put(id).put(schema).put_string(topic).put_string(message_encoding).put_array(entries.bytes());
    McapFieldWriter record;
    record.put_record(McapOpcode::channel, fields);
    output_.put(record.bytes());
    channels_.put_bytes(record.bytes());
    return id;
}

void McapWriter::write(std::uint16_t channel, std::int64_t log_time_ns, std::span<const std::byte> data) {
    const auto log_time = static_cast<std::uint64_t>(log_time_ns);
    chunk_.add(channel, message_counts_.at(channel - std::size_t{1})++, log_time, data);
    times_.add(log_time);
    if (chunk_.size() >= options_.chunk_bytes) {
        write_chunk();
    }
}

void McapWriter::write_chunk() {
    chunk_.write(output_, options_.compression, chunk_indexes_);
    ++chunk_count_;
}

void McapWriter::close() {
    if (chunk_.size() > 0) {
        write_chunk();
    }
    output_.put_record(McapOpcode::data_end, McapFieldWriter().put(output_.crc()));
    write_summary();
    output_.put(mcap_magic);
    output_.commit();
}

McapFieldWriter McapWriter::statistics() const {
    McapFieldWriter counts;
    for (std::size_t channel = 0; channel < message_counts_.size(); ++channel) {
        counts.put(static_cast<std::uint16_t>(channel + 1)).put(std::uint64_t{message_counts_[channel]});
    }
    const auto messages = std::accumulate(message_counts_.begin(), message_counts_.end(), std::uint64_t{0});
    return McapFieldWriter()
        .put(messages)
        .put(static_cast<std::uint16_t>(schema_ids_.size()))
        .put(static_cast<std::uint32_t>(message_counts_.size()))
        .put(std::uint32_t{0})  // number of attachments
        .put(std::uint32_t{0})  // number of metadata records
        .put(chunk_count_)
        .put(times_.first())
        .put(times_.last())
        .put_array(counts.bytes());
}

/// Writes the summary section, the offsets of its groups, and the footer.
void McapWriter::write_summary() {
    McapFieldWriter statistics_record;
    statistics_record.put_record(McapOpcode::statistics, statistics());
    const std::array<std::pair<McapOpcode, const McapFieldWriter*>, 4> groups = {{
        {McapOpcode::schema, &schemas_},
        {McapOpcode::channel, &channels_},
        {McapOpcode::statistics, &statistics_record},
        {McapOpcode::chunk_index, &chunk_indexes_},
    }};
    output_.restart_crc();
    const std::uint64_t summary_start = output_.offset();
    McapFieldWriter offsets;
    for (const auto& [opcode, records] : groups) {
        if (records->size() > 0) {
            offsets.put_record(McapOpcode::summary_offset, McapFieldWriter()
                                                               .put(static_cast<std::uint8_t>(opcode))
                                                               .put(output_.offset())
                                                               .put(std::uint64_t{records->size()}));
            output_.put(records->bytes());
        }
    }
    const std::uint64_t offsets_start = output_.offset();
    output_.put(offsets.bytes());
    // The CRC of the summary also covers the footer, up to the CRC itself.
    McapFieldWriter footer;
    footer.put_record_header(McapOpcode::footer, 2 * sizeof(std::uint64_t) + sizeof(std::uint32_t));
    output_.put(footer.put(summary_start).put(offsets_start).bytes());
    output_.put(McapFieldWriter().put(output_.crc()).bytes());
}

}  // namespace ddtool

#include "logs/containers/mcap_data_section.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/file_kind.hpp"
#include "logs/containers/mcap_fields.hpp"

namespace ddtool {
namespace {

constexpr std::size_t data_end_bytes = 4;
constexpr std::size_t footer_bytes = 20;

/// Reads a CRC. Returns 0, which stands for "not available", if the file ends before it.
std::uint32_t read_crc(ByteSource& source) {
    std::array<std::byte, sizeof(std::uint32_t)> bytes{};
    const bool whole = source.read(bytes) == bytes.size();
    return whole ? McapFieldReader(bytes).take<std::uint32_t>() : 0;
}

void check_mcap_magic(ByteSource& source) {
    std::vector<std::byte> start;
    source.append_to(start, mcap_magic.size());
    if (!std::ranges::equal(start, mcap_magic)) {
        throw Error(source.name() + ": not an MCAP file of version 0: it " + describe_file_start(start));
    }
}

}  // namespace

McapDataSection::McapDataSection(ByteSource source, LogProblemHandler on_problem)
    : source_(std::move(source)), on_problem_(std::move(on_problem)) {
    check_mcap_magic(source_);
}

std::optional<LogRecords> McapDataSection::next() {
    std::optional<LogRecords> records;
    while (!ended_ && !records) {
        offset_ = source_.offset();
        if (const auto record = read_record_header()) {
            records = read_record(*record);
        }
    }
    return records;
}

void McapDataSection::report(std::uint64_t offset, const std::string& what, std::uint64_t bytes_lost) {
    damaged_ = true;
    on_problem_({source_.name() + ": at byte " + std::to_string(offset) + ": " + what, offset, bytes_lost});
}

std::optional<McapDataSection::Record> McapDataSection::read_record_header() {
    const std::uint32_t crc_before = source_.crc();
    std::array<std::byte, mcap_record_header_bytes> bytes{};
    const std::size_t count = source_.read(bytes);
    McapFieldReader fields(bytes);
    const auto opcode = fields.take<std::uint8_t>();
    if (count == bytes.size() && opcode != 0) {
        return Record{McapOpcode{opcode}, fields.take<std::uint64_t>(), crc_before};
    }
    ended_ = true;
    if (count < bytes.size()) {
        report("the file ends without its footer: it was cut off, or is still being written", count);
    } else {
        report("a record of type 0, which there is not: nothing after it can be read",
               count + source_.skip(ByteSource::everything));
    }
    return std::nullopt;
}

std::optional<LogRecords> McapDataSection::read_record(const Record& record) {
    switch (record.opcode) {
        case McapOpcode::schema:
        case McapOpcode::channel:
        case McapOpcode::message:
        case McapOpcode::chunk:
            if (!in_summary_) {
                return read_held(record);
            }
            break;
        case McapOpcode::data_end:
            check_data_end(record);
            return std::nullopt;
        case McapOpcode::footer:
            check_footer(record);
            return std::nullopt;
        default:
            break;
    }
    pass_over(record);
    return std::nullopt;
}

std::optional<LogRecords> McapDataSection::read_held(const Record& record) {
    if (record.length > mcap_max_held_bytes) {
        refuse(record, "at most " + std::to_string(mcap_max_held_bytes));
        return std::nullopt;
    }
    return record.opcode == McapOpcode::chunk ? read_chunk(record) : read_single(record);
}

std::optional<LogRecords> McapDataSection::read_chunk(const Record& record) {
    const McapChunk chunk = chunks_.read(source_, record.length);
    if (!chunk.problem.empty()) {
        report(chunk.problem, chunk.bytes_lost);
    }
    ended_ = chunk.cut_off;
    return LogRecords{chunk.records, offset_, chunk.cut_off};
}

std::optional<LogRecords> McapDataSection::read_single(const Record& record) {
    McapFieldWriter header;
    header.put_record_header(record.opcode, record.length);
    single_.assign(header.bytes().begin(), header.bytes().end());
    const std::uint64_t count = source_.append_to(single_, record.length);
    if (count < record.length) {
        report_cut_off(record, count);
        return std::nullopt;
    }
    return LogRecords{single_, offset_, false};
}

void McapDataSection::pass_over(const Record& record) {
    const std::uint64_t count = source_.skip(record.length);
    if (count < record.length) {
        report_cut_off(record, count);
    }
}

void McapDataSection::refuse(const Record& record, const std::string& expected_length) {
    const std::uint64_t count = source_.skip(record.length);
    ended_ = count < record.length;
    report(name_of(record) + " is skipped: " + expected_length + " bytes were expected", count);
}

void McapDataSection::check_data_end(const Record& record) {
    if (record.length != data_end_bytes) {
        return refuse(record, std::to_string(data_end_bytes));
    }
    const std::uint32_t crc = read_crc(source_);
    if (crc != 0 && crc != record.crc_before && !damaged_) {
        report("the data before this do not match their CRC: what was read may be wrong");
    }
    in_summary_ = true;
    source_.restart_crc();
}

void McapDataSection::check_footer(const Record& record) {
    if (record.length != footer_bytes) {
        return refuse(record, std::to_string(footer_bytes));
    }
    source_.skip(footer_bytes - sizeof(std::uint32_t));
    const std::uint32_t actual_crc = source_.crc();
    const std::uint32_t crc = read_crc(source_);
    if (!in_summary_ && !damaged_) {
        report("the footer comes before a Data End: records may be missing before it");
    } else if (crc != 0 && crc != actual_crc && !damaged_) {
        report("the summary does not match its CRC; the messages are not affected");
    }
    check_end();
}

void McapDataSection::check_end() {
    ended_ = true;
    std::array<std::byte, mcap_magic.size()> end{};
    const std::size_t count = source_.read(end);
    source_.wait_no_more();
    const std::uint64_t more = source_.skip(ByteSource::everything);
    if (count < end.size()) {
        report("the file is cut off at its very end");
    } else if (end != mcap_magic) {
        report("the file does not end with the MCAP magic");
    }
    if (more > 0) {
        report(std::to_string(more) + " bytes follow the end of the MCAP file", more);
    }
}

std::string McapDataSection::name_of(const Record& record) {
    return "record of type " + std::to_string(static_cast<unsigned>(record.opcode)) + " and " +
           std::to_string(record.length) + " bytes";
}

void McapDataSection::report_cut_off(const Record& record, std::uint64_t count) {
    ended_ = true;
    report(name_of(record) + " is cut off after " + std::to_string(count) + ", or its length is wrong", count);
}

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/byte_source.hpp"
#include "logs/containers/log_records.hpp"
#include "logs/containers/mcap_chunk.hpp"
#include "logs/containers/mcap_format.hpp"

namespace ddtool {

/// Goes through the top-level records of a file, from the magic at its start to the one at its end, and checks lengths
/// and CRCs. Every problem is reported with its place.
class McapDataSection {
public:
    /// Throws Error if the source is not an MCAP file.
    McapDataSection(ByteSource source, LogProblemHandler on_problem);

    /// The next records; nullopt at the end.
    std::optional<LogRecords> next();
    /// Reports a problem of the records at `offset`.
    void report(std::uint64_t offset, const std::string& what, std::uint64_t bytes_lost);
    [[nodiscard]] double fraction_read() const { return source_.fraction_read(); }

private:
    struct Record {
        McapOpcode opcode{};
        std::uint64_t length = 0;
        std::uint32_t crc_before = 0;  ///< of the section up to the record
    };
    static std::string name_of(const Record& record);

    std::optional<Record> read_record_header();
    std::optional<LogRecords> read_record(const Record& record);
    std::optional<LogRecords> read_held(const Record& record);
    std::optional<LogRecords> read_chunk(const Record& record);
    std::optional<LogRecords> read_single(const Record& record);
    void pass_over(const Record& record);
    void refuse(const Record& record, const std::string& expected_length);
    void check_data_end(const Record& record);
    void check_footer(const Record& record);
    void check_end();
    void report_cut_off(const Record& record, std::uint64_t count);
    void report(const std::string& what, std::uint64_t bytes_lost = 0) { report(offset_, what, bytes_lost); }

    ByteSource source_;
    LogProblemHandler on_problem_;
    McapChunkReader chunks_;
    std::vector<std::byte> single_;
    std::uint64_t offset_ = 0;  ///< of the record being read
    bool in_summary_ = false;
    bool damaged_ = false;
    bool ended_ = false;
};

}  // namespace ddtool

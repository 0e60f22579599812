#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/bag_fields.hpp"
#include "logs/containers/byte_source.hpp"
#include "logs/containers/log_records.hpp"

namespace ddtool {

/// Goes through the top-level records of a bag, without its index. If a bag was never closed, its last chunk does not
/// declare a length, and the records of that chunk follow directly.
class BagSection {
public:
    /// Throws Error if the source is not a bag of version 2.0, or is encrypted.
    BagSection(ByteSource source, LogProblemHandler on_problem);

    /// The next records; nullopt at the end.
    std::optional<LogRecords> next();
    void report(std::uint64_t offset, const std::string& what, std::uint64_t bytes_lost);
    /// The offset in bytes at which the index begins, which repeats all connections; 0 if it is unknown.
    [[nodiscard]] std::uint64_t index_offset() const { return index_offset_; }
    [[nodiscard]] double fraction_read() const { return source_.fraction_read(); }

private:
    struct Record {
        BagFields header;
        std::uint32_t length = 0;  ///< of its data, in bytes
    };

    std::optional<std::uint32_t> read_length();
    /// Reads a header into header_ and returns the length of the data after it.
    std::optional<std::uint32_t> read_header();
    std::optional<LogRecords> read_record(std::uint32_t data_length);
    std::optional<LogRecords> interpret(const Record& record);
    std::optional<LogRecords> read_single(const Record& record);
    std::optional<LogRecords> read_chunk(const Record& record);
    std::optional<LogRecords> read_open_chunk(const std::string& compression);
    void pass_over(const Record& record);
    void check_end();
    void give_up_at_header(std::uint32_t length);
    void report_cut_off();

    ByteSource source_;
    LogProblemHandler on_problem_;
    std::vector<std::byte> header_;  ///< of the record being read
    std::vector<std::byte> stored_;  ///< the data of that record, if they are held in memory
    std::vector<std::byte> decompressed_;
    std::uint64_t offset_ = 0;  ///< of the record being read
    std::uint64_t index_offset_ = 0;
    bool ended_ = false;
};

}  // namespace ddtool

#include "logs/containers/bag_section.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/compression.hpp"
#include "logs/containers/file_kind.hpp"
#include "logs/containers/mcap_fields.hpp"

namespace ddtool {
namespace {

constexpr std::string_view magic = "#ROSBAG V2.0\n";
/// Limits of this reader, not of the format. A larger size is taken for damage.
constexpr std::uint32_t max_header_bytes = 1U << 20U;
constexpr std::uint32_t max_chunk_bytes = 1U << 30U;

void check_bag_magic(ByteSource& source) {
    std::vector<std::byte> start;
    source.append_to(start, magic.size());
    if (!std::ranges::equal(start, std::as_bytes(std::span(magic)))) {
        const std::string version(reinterpret_cast<const char*>(start.data()), start.size());
        throw Error(source.name() + ": not a ROS 1 bag of version 2.0: it " + describe_file_start(start) +
                    (version.starts_with("#ROSBAG V") ? " of another version; `rosbag fix` renews it" : ""));
    }
}

/// Throws Error if the header of the bag, its first record, names an encryptor.
void check_not_encrypted(ByteSource& source) {
    std::span<const std::byte> start = source.start(sizeof(std::uint32_t));
    const std::uint32_t length = start.size() < sizeof length ? 0 : McapFieldReader(start).take<std::uint32_t>();
    if (length == 0 || length > max_header_bytes) {
        return;
    }
    start = source.start(sizeof length + length).subspan(sizeof length);
    std::string encryptor;
    try {
        encryptor = BagFields(start).text("encryptor");
    } catch (const Error&) {  // NOLINT(bugprone-empty-catch): there is none, or the header is damaged
    }
    if (!encryptor.empty() && encryptor != "rosbag/NoEncryptor") {
        throw Error(source.name() + ": is an encrypted ROS 1 bag (" + encryptor +
                    "); `rosbag decrypt FILE` makes one that can be read, where its key is");
    }
}

Compression compression_of(const std::string& name) {
    constexpr std::array<std::pair<std::string_view, Compression>, 3> known{
        {{"none", Compression::none}, {"lz4", Compression::lz4}, {"bz2", Compression::bzip2}}};
    const auto* const found = std::ranges::find_if(known, [&](const auto& one) { return one.first == name; });
    if (found == known.end()) {
        throw Error("compression '" + name + "' where 'none', 'lz4' or 'bz2' was expected");
    }
    return found->second;
}

}  // namespace

BagSection::BagSection(ByteSource source, LogProblemHandler on_problem)
    : source_(std::move(source)), on_problem_(std::move(on_problem)) {
    check_bag_magic(source_);
    check_not_encrypted(source_);
}

std::optional<LogRecords> BagSection::next() {
    std::optional<LogRecords> records;
    while (!ended_ && !records) {
        offset_ = source_.offset();
        if (const auto data_length = read_header()) {
            records = read_record(*data_length);
        }
    }
    return records;
}

void BagSection::report(std::uint64_t offset, const std::string& what, std::uint64_t bytes_lost) {
    on_problem_({source_.name() + ": at byte " + std::to_string(offset) + ": " + what, offset, bytes_lost});
}

std::optional<std::uint32_t> BagSection::read_length() {
    std::array<std::byte, sizeof(std::uint32_t)> bytes{};
    const bool whole = source_.read(bytes) == bytes.size();
    return whole ? std::optional(McapFieldReader(bytes).take<std::uint32_t>()) : std::nullopt;
}

std::optional<std::uint32_t> BagSection::read_header() {
    const auto length = read_length();
    if (!length && source_.offset() == offset_) {
        check_end();
        return std::nullopt;
    }
    if (length.value_or(0) > max_header_bytes) {
        give_up_at_header(*length);
        return std::nullopt;
    }
    header_.clear();
    source_.append_to(header_, length.value_or(0));
    const auto data_length = read_length();
    if (!data_length) {
        report_cut_off();
    }
    return data_length;
}

std::optional<LogRecords> BagSection::read_record(std::uint32_t data_length) {
    const std::uint64_t end = source_.offset() + data_length;
    try {
        return interpret({BagFields(header_), data_length});
    } catch (const Error& error) {
        source_.skip(end - source_.offset());
        report(offset_, std::string("record is skipped: ") + error.what(), source_.offset() - offset_);
        return std::nullopt;
    }
}

std::optional<LogRecords> BagSection::interpret(const Record& record) {
    switch (record.header.opcode()) {
        case BagOpcode::message:
        case BagOpcode::connection:
            return read_single(record);
        case BagOpcode::chunk:
            return read_chunk(record);
        case BagOpcode::bag_header:
            index_offset_ = record.header.number<std::uint64_t>("index_pos");
            break;
        default:
            break;
    }
    pass_over(record);
    return std::nullopt;
}

std::optional<LogRecords> BagSection::read_single(const Record& record) {
    McapFieldWriter whole;
    whole.put_array(header_).put(record.length);
    stored_.assign(whole.bytes().begin(), whole.bytes().end());
    if (source_.append_to(stored_, record.length) < record.length) {
        report_cut_off();
        return std::nullopt;
    }
    return LogRecords{stored_, offset_, false};
}

std::optional<LogRecords> BagSection::read_chunk(const Record& record) {
    const std::string& compression = record.header.text("compression");
    const auto size = record.header.number<std::uint32_t>("size");
    if (size == 0 && record.length == 0) {
        return read_open_chunk(compression);
    }
    if (size > max_chunk_bytes) {
        throw Error("a chunk of " + std::to_string(size) + " bytes where at most " + std::to_string(max_chunk_bytes) +
                    " were expected");
    }
    stored_.clear();
    const bool cut_off = source_.append_to(stored_, record.length) < record.length;
    if (cut_off) {
        report_cut_off();
    }
    const auto [records, failure] = decompress(compression_of(compression), stored_, size, decompressed_);
    if (!failure.empty() && !cut_off) {
        throw Error("its chunk: " + failure);
    }
    return LogRecords{records, offset_, cut_off};
}

std::optional<LogRecords> BagSection::read_open_chunk(const std::string& compression) {
    if (compression_of(compression) == Compression::none) {
        return std::nullopt;
    }
    ended_ = true;
    stored_.clear();
    source_.append_to(stored_, max_chunk_bytes);
    check_end();
    const auto records = decompress(compression_of(compression), stored_, max_chunk_bytes, decompressed_).records;
    return LogRecords{records, offset_, true};
}

void BagSection::pass_over(const Record& record) {
    if (source_.skip(record.length) < record.length) {
        report_cut_off();
    }
}

void BagSection::check_end() {
    ended_ = true;
    if (index_offset_ == 0) {
        report(source_.offset(), "the bag was never closed (its recorder was stopped hard, or is still at it)", 0);
    } else if (source_.offset() <= index_offset_) {
        report(source_.offset(), "the bag ends before its index: it was cut off", 0);
    }
}

void BagSection::give_up_at_header(std::uint32_t length) {
    ended_ = true;
    source_.skip(ByteSource::everything);
    report(offset_,
           "a record header of " + std::to_string(length) + " bytes where at most " + std::to_string(max_header_bytes) +
               " were expected: nothing after it can be read",
           source_.offset() - offset_);
}

void BagSection::report_cut_off() {
    ended_ = true;
    const std::uint64_t count = source_.offset() - offset_;
    report(offset_, "the last record is cut off after " + std::to_string(count) + " bytes, or its length is wrong",
           count);
}

}  // namespace ddtool

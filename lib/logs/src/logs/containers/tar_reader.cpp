#include "logs/containers/tar_reader.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

namespace ddtool {
namespace {

constexpr std::size_t tar_block_bytes = 512;
constexpr std::uint64_t longest_name_bytes = std::uint64_t{1} << 20;

using TarBlock = std::span<const std::byte>;

/// A field of a header that holds text, which ends at its first null.
std::string_view text_field(TarBlock header, std::size_t at, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(header.data()) + at, size);
    return text.substr(0, text.find('\0'));
}

/// A field that holds a number: octal digits, or, as GNU tar writes large ones, big-endian bytes of which the first has
/// its highest bit set.
std::uint64_t number_field(TarBlock header, std::size_t at, std::size_t size) {
    std::uint64_t value = 0;
    if ((header[at] & std::byte{0x80}) != std::byte{}) {
        for (std::size_t i = 1; i < size; ++i) {
            value = value << 8U | std::to_integer<std::uint64_t>(header[at + i]);
        }
        return value;
    }
    std::string_view digits = text_field(header, at, size);
    digits.remove_prefix(std::min(digits.find_first_not_of(' '), digits.size()));
    std::from_chars(digits.data(), digits.data() + digits.size(), value, 8);
    return value;
}

bool has_checksum(TarBlock header) {
    constexpr std::size_t checksum_at = 148;
    constexpr std::size_t checksum_bytes = 8;
    std::uint64_t sum = 0;
    for (std::size_t i = 0; i < tar_block_bytes; ++i) {
        const bool is_checksum = i >= checksum_at && i < checksum_at + checksum_bytes;
        sum += is_checksum ? std::uint64_t{' '} : std::to_integer<std::uint64_t>(header[i]);
    }
    return sum == number_field(header, checksum_at, checksum_bytes);
}

std::uint64_t padding_of(std::uint64_t size) { return (tar_block_bytes - size % tar_block_bytes) % tar_block_bytes; }

std::string name_in(TarBlock header) {
    const std::string name(text_field(header, 0, 100));
    const bool has_prefix = text_field(header, 257, 5) == "ustar" && header[262] == std::byte{};
    const std::string prefix(has_prefix ? text_field(header, 345, 155) : "");
    return prefix.empty() ? name : prefix + "/" + name;
}

}  // namespace

bool is_tar(std::span<const std::byte> start) {
    return start.size() >= tar_block_bytes && start[0] != std::byte{} && has_checksum(start);
}

std::optional<TarReader::Entry> TarReader::next() {
    for (;;) {
        if (cut_off_ || source_.skip(left_ + padding_) < left_ + padding_) {
            return std::nullopt;
        }
        left_ = padding_ = 0;
        std::array<std::byte, tar_block_bytes> header{};
        if (source_.read(header) < header.size() || !is_tar(header)) {
            return std::nullopt;
        }
        const auto type = std::to_integer<char>(header[156]);
        const std::uint64_t size = number_field(header, 124, 12);
        if (type == 'L') {
            long_name_ = take_text(size);
            long_name_.resize(std::min(long_name_.find('\0'), long_name_.size()));
        } else if (type == 'x') {
            take_pax(take_text(size));
        } else {
            const std::string name = std::exchange(long_name_, "");
            left_ = std::exchange(long_size_, std::nullopt).value_or(size);
            padding_ = padding_of(left_);
            if (type == '0' || type == '\0' || type == '7') {
                return Entry{name.empty() ? name_in(header) : name, left_};
            }
        }
    }
}

std::size_t TarReader::read(std::span<std::byte> into) {
    const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(into.size(), left_));
    const std::size_t count = source_.read(into.first(wanted));
    left_ -= count;
    cut_off_ = cut_off_ || count < wanted;
    return count;
}

std::string TarReader::take_text(std::uint64_t size) {
    std::vector<std::byte> bytes;
    source_.append_to(bytes, std::min(size, longest_name_bytes));
    source_.skip(size - std::min(size, longest_name_bytes) + padding_of(size));
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Takes the records of a pax header, each of them "LENGTH KEY=VALUE\n" with its own length.
void TarReader::take_pax(const std::string& records) {
    std::string_view rest = records;
    for (;;) {
        std::size_t length = 0;
        const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), length);
        const auto digits = static_cast<std::size_t>(end - rest.data());
        if (failure != std::errc() || length > rest.size() || length < digits + 2) {
            return;
        }
        const std::string_view record = rest.substr(digits + 1, length - digits - 2);
        const std::string_view value = record.substr(std::min(record.find('=') + 1, record.size()));
        if (record.starts_with("path=")) {
            long_name_ = value;
        } else if (record.starts_with("size=")) {
            std::uint64_t size = 0;
            std::from_chars(value.data(), value.data() + value.size(), size);
            long_size_ = size;
        }
        rest.remove_prefix(length);
    }
}

}  // namespace ddtool

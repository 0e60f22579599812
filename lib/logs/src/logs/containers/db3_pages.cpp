#include "logs/containers/db3_pages.hpp"

#include <algorithm>
#include <array>
#include <bit>

namespace ddtool {
namespace {

constexpr std::size_t database_header_bytes = 100;
constexpr std::size_t leaf_header_bytes = 8;
constexpr std::byte table_leaf{0x0D};

/// A big-endian number of at most eight bytes, which are all there.
std::uint64_t big_endian(std::span<const std::byte> bytes) {
    std::uint64_t value = 0;
    for (const std::byte byte : bytes) {
        value = value << 8U | std::to_integer<std::uint64_t>(byte);
    }
    return value;
}

/// Takes a variable-length integer from the front of the bytes; nullopt if they end before it does.
std::optional<std::uint64_t> take_varint(std::span<const std::byte>& bytes) {
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < std::min<std::size_t>(9, bytes.size()); ++i) {
        const auto byte = std::to_integer<std::uint64_t>(bytes[i]);
        const bool is_last = i == 8 || byte < 0x80U;
        value = i == 8 ? value << 8U | byte : value << 7U | (byte & 0x7FU);
        if (is_last) {
            bytes = bytes.subspan(i + 1);
            return value;
        }
    }
    return std::nullopt;
}

/// The number of bytes of a value, by its serial type in the record format.
std::uint64_t bytes_of_type(std::uint64_t type) {
    constexpr std::array<std::uint64_t, 12> sizes{0, 1, 2, 3, 4, 6, 8, 8, 0, 0, 0, 0};
    return type < sizes.size() ? sizes[static_cast<std::size_t>(type)] : (type - 12) / 2;
}

Db3Value value_of(std::uint64_t type, std::span<const std::byte> bytes) {
    Db3Value value;
    if (type >= 12) {
        value.type = type % 2 == 0 ? Db3Value::Type::blob : Db3Value::Type::text;
        value.bytes = bytes;
    } else if (type == 7) {
        value.type = Db3Value::Type::real;
    } else if (type == 8 || type == 9) {
        value.type = Db3Value::Type::integer;
        value.integer = static_cast<std::int64_t>(type - 8);
    } else if (type > 0 && type < 7) {  // 10 and 11 are reserved and have no bytes
        value.type = Db3Value::Type::integer;
        const unsigned unused_bits = 64U - 8U * static_cast<unsigned>(bytes.size());
        value.integer = std::bit_cast<std::int64_t>(big_endian(bytes) << unused_bits) >> unused_bits;
    }
    return value;
}

}  // namespace

Db3Pages::Db3Pages(std::span<const std::byte> file) : file_(file) {
    if (file.size() < database_header_bytes) {
        return;
    }
    const std::uint64_t stated = big_endian(file.subspan(16, 2));
    page_bytes_ = stated == 1 ? 65536 : static_cast<std::size_t>(stated);
    const auto reserved = static_cast<std::size_t>(file[20]);
    if (!std::has_single_bit(page_bytes_) || page_bytes_ < 512 || reserved > page_bytes_ - 480) {
        return;
    }
    usable_bytes_ = page_bytes_ - reserved;
    pages_ = static_cast<std::uint32_t>(std::min<std::size_t>(file.size() / page_bytes_, UINT32_MAX));
}

std::optional<std::uint64_t> Db3Pages::declared_bytes() const {
    // The number of pages counts only if the last writer kept it up: then the change counters are equal.
    const bool is_told = pages_ > 0 && big_endian(file_.subspan(24, 4)) == big_endian(file_.subspan(92, 4));
    const std::uint64_t pages = is_told ? big_endian(file_.subspan(28, 4)) : 0;
    return pages > 0 ? std::optional(pages * page_bytes_) : std::nullopt;
}

std::span<const std::byte> Db3Pages::page(std::uint32_t number) const {
    return file_.subspan((static_cast<std::size_t>(number) - 1) * page_bytes_, usable_bytes_);
}

std::vector<Db3Cell> Db3Pages::cells(std::uint32_t number) const {
    std::vector<Db3Cell> cells;
    const std::span<const std::byte> bytes = page(number);
    const std::size_t start = number == 1 ? database_header_bytes : 0;
    if (bytes[start] != table_leaf) {
        return cells;
    }
    const std::size_t count = big_endian(bytes.subspan(start + 3, 2));
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t pointer_at = start + leaf_header_bytes + 2 * i;
        if (pointer_at + 2 > bytes.size()) {
            break;
        }
        const std::size_t at = big_endian(bytes.subspan(pointer_at, 2));
        std::span<const std::byte> cell = bytes.subspan(std::min(at, bytes.size()));
        const auto payload_bytes = take_varint(cell);
        const auto id = payload_bytes ? take_varint(cell) : std::nullopt;
        if (id && *payload_bytes > 0 && *payload_bytes <= file_.size()) {
            cells.push_back({std::bit_cast<std::int64_t>(*id), *payload_bytes, number, bytes.size() - cell.size()});
        }
    }
    return cells;
}

/// How much of a payload is in the leaf page itself; the rest is in overflow pages.
std::size_t Db3Pages::local_bytes(std::uint64_t payload_bytes) const {
    const std::size_t most = usable_bytes_ - 35;
    if (payload_bytes <= most) {
        return static_cast<std::size_t>(payload_bytes);
    }
    const std::size_t least = (usable_bytes_ - 12) * 32 / 255 - 23;
    const std::size_t filled = least + static_cast<std::size_t>((payload_bytes - least) % (usable_bytes_ - 4));
    return filled <= most ? filled : least;
}

/// Puts the whole payload of a row into payload_; returns whether all of it is there.
bool Db3Pages::gather(const Db3Cell& cell) {
    constexpr std::size_t link_bytes = 4;
    const std::size_t local = local_bytes(cell.payload_bytes);
    const bool overflows = local < cell.payload_bytes;
    std::span<const std::byte> rest = page(cell.page).subspan(cell.local_at);
    if (rest.size() < local + (overflows ? link_bytes : 0)) {
        return false;
    }
    payload_.assign(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(local));
    std::uint64_t next = overflows ? big_endian(rest.subspan(local, link_bytes)) : 0;
    while (payload_.size() < cell.payload_bytes) {
        if (next < 2 || next > pages_) {
            return false;
        }
        rest = page(static_cast<std::uint32_t>(next));
        next = big_endian(rest.first(link_bytes));
        rest = rest.subspan(link_bytes);
        rest = rest.first(std::min<std::size_t>(rest.size(), cell.payload_bytes - payload_.size()));
        payload_.insert(payload_.end(), rest.begin(), rest.end());
    }
    return true;
}

std::optional<std::vector<Db3Value>> Db3Pages::row(const Db3Cell& cell) {
    if (!gather(cell)) {
        return std::nullopt;
    }
    std::span<const std::byte> header = payload_;
    const std::uint64_t header_bytes = take_varint(header).value_or(0);
    const std::size_t size_bytes = payload_.size() - header.size();
    if (header_bytes < size_bytes || header_bytes > payload_.size()) {
        return std::nullopt;
    }
    std::span<const std::byte> content = std::span<const std::byte>(payload_).subspan(header_bytes);
    header = header.first(header_bytes - size_bytes);
    std::vector<Db3Value> values;
    while (!header.empty()) {
        const auto type = take_varint(header);
        if (!type || bytes_of_type(*type) > content.size()) {
            return std::nullopt;
        }
        const auto size = static_cast<std::size_t>(bytes_of_type(*type));
        values.push_back(value_of(*type, content.first(size)));
        content = content.subspan(size);
    }
    return values;
}

}  // namespace ddtool

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ddtool {

/// Where a row of a table lies in an SQLite database: its cell in a leaf page of the table.
struct Db3Cell {
    std::int64_t id = 0;  ///< the rowid
    std::uint64_t payload_bytes = 0;
    std::uint32_t page = 0;    ///< from 1
    std::size_t local_at = 0;  ///< where its payload begins in that page
};

/// A column of a row. Texts and blobs are valid until the next row is read.
struct Db3Value {
    enum class Type { null, integer, real, text, blob };

    Type type = Type::null;
    std::int64_t integer = 0;
    std::span<const std::byte> bytes;  ///< of a text or a blob

    [[nodiscard]] std::string_view text() const { return {reinterpret_cast<const char*>(bytes.data()), bytes.size()}; }
};

/// The rows in the table leaf pages of an SQLite database (https://www.sqlite.org/fileformat2.html), read page by page
/// without the trees that lead to them, so that a page that is damaged or missing hides no other. Bytes that do not
/// make sense are no rows; nothing here throws.
class Db3Pages {
public:
    /// \param file the database, which must stay valid; its journal is not read
    explicit Db3Pages(std::span<const std::byte> file);

    /// The number of whole pages in the file; 0 if it is no database.
    [[nodiscard]] std::uint32_t pages() const { return pages_; }
    /// The bytes that the database has according to its header; nullopt if the header does not tell.
    [[nodiscard]] std::optional<std::uint64_t> declared_bytes() const;
    /// The rows of a page, in its order; none if it is no leaf page of a table.
    [[nodiscard]] std::vector<Db3Cell> cells(std::uint32_t page) const;
    /// The columns of a row. Returns nullopt if a part of it is damaged or missing.
    [[nodiscard]] std::optional<std::vector<Db3Value>> row(const Db3Cell& cell);

private:
    [[nodiscard]] std::span<const std::byte> page(std::uint32_t number) const;
    [[nodiscard]] std::size_t local_bytes(std::uint64_t payload_bytes) const;
    bool gather(const Db3Cell& cell);

    std::span<const std::byte> file_;
    std::size_t page_bytes_ = 0;
    std::size_t usable_bytes_ = 0;  ///< of a page
    std::uint32_t pages_ = 0;
    std::vector<std::byte> payload_;
};

}  // namespace ddtool

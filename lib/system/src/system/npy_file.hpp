#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <type_traits>

#include "system/mapped_file.hpp"

namespace ddtool {

/// The form of the rows of an .npy file (NumPy Enhancement Proposal 1, format 1.0, C order).
struct NpyFormat {
    std::string descr;        ///< dtype as NumPy prints it: '<f8' with its quotes, or a list of fields
    std::size_t columns = 0;  ///< length of the second axis; 0: the array has one axis
};

/// Writes a whole file: a header for `rows` rows, and then the bytes that write_rows writes, which must be those of
/// exactly that many rows. Throws OutputError naming the file.
void write_npy(const std::filesystem::path& path, const NpyFormat& format, std::size_t rows,
               const std::function<void(std::ostream&)>& write_rows);

/// The bytes of the rows in the bytes of an .npy file.
/// \param path names the file in messages
/// \param row_bytes the size of one row
/// Throws Error naming `path` if the file has another format, or is too short or too long.
std::span<const std::byte> npy_rows(std::span<const std::byte> file, const std::filesystem::path& path,
                                    const NpyFormat& format, std::size_t row_bytes);

/// An .npy file as rows of a plain struct of the same layout, without copying.
template <typename Row>
class MappedNpy {
    static_assert(std::is_trivially_copyable_v<Row> && std::is_standard_layout_v<Row>);

public:
    /// Throws Error as MappedFile and npy_rows() do.
    MappedNpy(const std::filesystem::path& path, const NpyFormat& format) : file_(path) {
        const std::span<const std::byte> bytes = npy_rows(file_.bytes(), path, format, sizeof(Row));
        rows_ = {reinterpret_cast<const Row*>(bytes.data()), bytes.size() / sizeof(Row)};
    }
    [[nodiscard]] std::span<const Row> rows() const { return rows_; }
    [[nodiscard]] const MappedFile& file() const { return file_; }

private:
    MappedFile file_;
    std::span<const Row> rows_;
};

/// The bytes of plain rows, for writing.
template <typename Row>
std::span<const char> bytes_of(std::span<const Row> rows) {
    static_assert(std::is_trivially_copyable_v<Row>);
    return {reinterpret_cast<const char*>(rows.data()), rows.size_bytes()};
}

}  // namespace ddtool

#include "system/npy_file.hpp"

#include <charconv>
#include <ostream>
#include <string_view>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

constexpr std::string_view magic{"\x93NUMPY\x01\x00", 8};
constexpr std::size_t preamble_bytes = magic.size() + 2;  // two bytes for the length of the text that follows
constexpr std::size_t alignment_bytes = 64;
constexpr std::string_view shape_key = "'shape': (";

std::string header_text(const NpyFormat& format, std::size_t rows) {
    std::string text = "{'descr': ";
    text += format.descr;
    text += ", 'fortran_order': False, ";
    text += shape_key;
    text += std::to_string(rows) + ",";
    if (format.columns > 0) {
        text += " " + std::to_string(format.columns);
    }
    return text += "), }";
}

std::string header(const NpyFormat& format, std::size_t rows) {
    std::string text = header_text(format, rows);
    const std::size_t unpadded = preamble_bytes + text.size() + 1;
    text.append((alignment_bytes - unpadded % alignment_bytes) % alignment_bytes, ' ');
    text += '\n';
    std::string bytes(magic);
    bytes += static_cast<char>(text.size() & 0xffU);
    bytes += static_cast<char>(text.size() >> 8U);
    return bytes + text;
}

std::size_t rows_of(std::string_view text) {
    std::size_t rows = 0;
    const std::size_t at = text.rfind(shape_key);
    if (at != std::string_view::npos) {
        std::from_chars(text.data() + at + shape_key.size(), text.data() + text.size(), rows);
    }
    return rows;
}

/// The text of the header without its padding, because versions of NumPy pad it to different lengths.
std::string_view text_of(std::span<const std::byte> file, std::size_t text_bytes) {
    std::string_view text(reinterpret_cast<const char*>(file.data()) + preamble_bytes, text_bytes);
    text.remove_suffix(text.size() - (text.find_last_not_of(" \n") + 1));
    return text;
}

}  // namespace

void write_npy(const std::filesystem::path& path, const NpyFormat& format, std::size_t rows,
               const std::function<void(std::ostream&)>& write_rows) {
    write_file(path, [&](std::ostream& out) {
        out << header(format, rows);
        write_rows(out);
    });
}

std::span<const std::byte> npy_rows(std::span<const std::byte> file, const std::filesystem::path& path,
                                    const NpyFormat& format, std::size_t row_bytes) {
    const auto fail = [&](const std::string& what) { throw Error(path.string() + ": " + what); };
    if (file.size() < preamble_bytes ||
        std::string_view(reinterpret_cast<const char*>(file.data()), magic.size()) != magic) {
        fail("not a NumPy file of format 1.0");
    }
    const auto length = [&](std::size_t at) { return std::to_integer<std::size_t>(file[magic.size() + at]); };
    const std::size_t start = preamble_bytes + length(0) + (length(1) << 8U);
    if (start > file.size()) {
        fail("cut within its header");
    }
    const std::string_view text = text_of(file, start - preamble_bytes);
    const std::size_t rows = rows_of(text);
    if (text != header_text(format, rows) || start % alignment_bytes != 0) {
        fail("another kind of NumPy array; expected " + header_text(format, rows));
    }
    if ((file.size() - start) / row_bytes != rows || (file.size() - start) % row_bytes != 0) {
        fail("cut or damaged: " + std::to_string(file.size()) + " bytes, expected " +
             std::to_string(start + rows * row_bytes));
    }
    return file.subspan(start);
}

}  // namespace ddtool

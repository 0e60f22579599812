#pragma once

#include <bzlib.h>
#include <zlib.h>

#include <string>

namespace ddtool::test {

inline std::string plain(const std::string& text) { return text; }

inline std::string gzip(const std::string& text) {
    z_stream stream{};
    constexpr int gzip_window = 15 + 16;
    deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY);
    std::string packed(deflateBound(&stream, text.size()), '\0');
    std::string input = text;
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<unsigned>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(packed.data());
    stream.avail_out = static_cast<unsigned>(packed.size());
    deflate(&stream, Z_FINISH);
    packed.resize(stream.total_out);
    deflateEnd(&stream);
    return packed;
}

/// Compresses in blocks of 100 kB, so that a text that was cut off still has its first blocks.
inline std::string bzip2(const std::string& text) {
    std::string input = text;
    auto size = static_cast<unsigned>(text.size() + text.size() / 100 + 600);
    std::string packed(size, '\0');
    BZ2_bzBuffToBuffCompress(packed.data(), &size, input.data(), static_cast<unsigned>(input.size()), 1, 0, 0);
    packed.resize(size);
    return packed;
}

}  // namespace ddtool::test

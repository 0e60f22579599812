#include "logs/containers/compression.hpp"

#include <bzlib.h>
#include <lz4frame.h>
#include <zlib.h>
#include <zstd.h>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr std::size_t first_buffer_bytes = std::size_t{64} << 10;

class Lz4Decoder : public Decoder {
public:
    Lz4Decoder() {
        LZ4F_dctx* context = nullptr;
        if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0U) {
            throw Error("lz4: out of memory");
        }
        context_.reset(context);
    }

    Step step(std::span<const std::byte> in, std::span<std::byte> out) override {
        std::size_t taken = in.size();
        std::size_t given = out.size();
        const std::size_t result = LZ4F_decompress(context_.get(), out.data(), &given, in.data(), &taken, nullptr);
        return {taken, given, result == 0, LZ4F_isError(result) != 0U ? LZ4F_getErrorName(result) : ""};
    }

private:
    struct Free {
        void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
    };
    std::unique_ptr<LZ4F_dctx, Free> context_;
};

class ZstdDecoder : public Decoder {
public:
    Step step(std::span<const std::byte> in, std::span<std::byte> out) override {
        ZSTD_inBuffer input{in.data(), in.size(), 0};
        ZSTD_outBuffer output{out.data(), out.size(), 0};
        const std::size_t result = ZSTD_decompressStream(context_.get(), &output, &input);
        return {input.pos, output.pos, result == 0, ZSTD_isError(result) != 0U ? ZSTD_getErrorName(result) : ""};
    }

private:
    struct Free {
        void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
    };
    std::unique_ptr<ZSTD_DCtx, Free> context_{ZSTD_createDCtx()};
};

std::string bzip2_error(int code) {
    switch (code) {
        case BZ_OK:
        case BZ_STREAM_END:
            return "";
        case BZ_DATA_ERROR_MAGIC:
            return "not bzip2 data";
        case BZ_DATA_ERROR:
            return "damaged bzip2 data";
        default:
            return "bzip2 error " + std::to_string(code);
    }
}

unsigned bzip2_size(std::size_t size) {
    return static_cast<unsigned>(std::min<std::size_t>(size, std::numeric_limits<unsigned>::max()));
}

class Bzip2Decoder : public Decoder {
public:
    Bzip2Decoder() {
        if (BZ2_bzDecompressInit(stream_.get(), 0, 0) != BZ_OK) {
            throw Error("bzip2: out of memory");
        }
    }

    Step step(std::span<const std::byte> in, std::span<std::byte> out) override {
        // The library does not write to its input, but its interface does not use const.
        stream_->next_in = const_cast<char*>(reinterpret_cast<const char*>(in.data()));  // NOLINT(*-const-cast)
        stream_->avail_in = bzip2_size(in.size());
        stream_->next_out = reinterpret_cast<char*>(out.data());
        stream_->avail_out = bzip2_size(out.size());
        const int code = BZ2_bzDecompress(stream_.get());
        return {bzip2_size(in.size()) - stream_->avail_in, bzip2_size(out.size()) - stream_->avail_out,
                code == BZ_STREAM_END, bzip2_error(code)};
    }

private:
    struct Free {
        void operator()(bz_stream* stream) const {
            BZ2_bzDecompressEnd(stream);
            delete stream;
        }
    };
    std::unique_ptr<bz_stream, Free> stream_{new bz_stream{}};  // on the heap, because bzip2 keeps its address
};

class GzipDecoder : public Decoder {
public:
    GzipDecoder() {
        constexpr int gzip_window = 15 + 16;  // the largest window, and gzip's header, as zlib wants it
        if (::inflateInit2(&stream_, gzip_window) != Z_OK) {
            throw Error("gzip: out of memory");
        }
    }
    ~GzipDecoder() override { ::inflateEnd(&stream_); }

    Step step(std::span<const std::byte> in, std::span<std::byte> out) override {
        const auto size = [](std::size_t bytes) {
            return static_cast<uInt>(std::min<std::size_t>(bytes, std::numeric_limits<uInt>::max()));
        };
        stream_.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(in.data()));  // NOLINT(*-const-cast)
        stream_.avail_in = size(in.size());
        stream_.next_out = reinterpret_cast<Bytef*>(out.data());
        stream_.avail_out = size(out.size());
        const int code = ::inflate(&stream_, Z_NO_FLUSH);
        const bool failed = code != Z_OK && code != Z_STREAM_END && code != Z_BUF_ERROR;
        const char* const reason = stream_.msg == nullptr ? "damaged gzip data" : stream_.msg;
        return {size(in.size()) - stream_.avail_in, size(out.size()) - stream_.avail_out, code == Z_STREAM_END,
                failed ? reason : ""};
    }

private:
    z_stream stream_{};
};

/// Returns the free part of the buffer after the first `used` bytes, limited to `limit` bytes in all. If there is none,
/// the buffer is doubled first.
std::span<std::byte> room(std::vector<std::byte>& buffer, std::size_t used, std::size_t limit) {
    if (used == buffer.size()) {
        buffer.resize(std::min(limit, std::max(first_buffer_bytes, 2 * buffer.size())));
    }
    return std::span(buffer).subspan(used, std::min(limit, buffer.size()) - used);
}

std::string size_failure(std::uint64_t size, std::uint64_t expected_size) {
    return "decompresses to " + std::to_string(size) + " bytes where " + std::to_string(expected_size) +
           " are declared";
}

Decompressed decoded_by(Decoder& decoder, std::span<const std::byte> in, std::uint64_t expected_size,
                        std::vector<std::byte>& buffer) {
    // One byte more than expected, so that an output that is too long is noticed.
    const auto limit = static_cast<std::size_t>(expected_size) + 1;
    std::size_t used = 0;
    std::string failure;
    while (failure.empty() && used < limit) {
        const Decoder::Step step = decoder.step(in, room(buffer, used, limit));
        in = in.subspan(step.taken);
        used += step.given;
        failure = step.error;
        if (step.ended || (step.taken == 0 && step.given == 0)) {
            break;
        }
    }
    if (failure.empty() && used == limit) {
        failure = "decompresses to more than the declared " + std::to_string(expected_size) + " bytes";
    } else if (failure.empty() && used < expected_size) {
        failure = size_failure(used, expected_size);
    }
    return {std::span(buffer).first(std::min<std::size_t>(used, limit - 1)), std::move(failure)};
}

std::vector<std::byte> compress_lz4(std::span<const std::byte> records) {
    std::vector<std::byte> compressed(LZ4F_compressFrameBound(records.size(), nullptr));
    const std::size_t size =
        LZ4F_compressFrame(compressed.data(), compressed.size(), records.data(), records.size(), nullptr);
    if (LZ4F_isError(size) != 0U) {
        throw Error(std::string("lz4: ") + LZ4F_getErrorName(size));
    }
    compressed.resize(size);
    return compressed;
}

std::vector<std::byte> compress_zstd(std::span<const std::byte> records) {
    std::vector<std::byte> compressed(ZSTD_compressBound(records.size()));
    const std::size_t size =
        ZSTD_compress(compressed.data(), compressed.size(), records.data(), records.size(), ZSTD_CLEVEL_DEFAULT);
    if (ZSTD_isError(size) != 0U) {
        throw Error(std::string("zstd: ") + ZSTD_getErrorName(size));
    }
    compressed.resize(size);
    return compressed;
}

std::vector<std::byte> compress_bzip2(std::span<const std::byte> records) {
    // Large enough for any input, according to bzip2's manual, section 3.5.1: 1 % and 600 bytes more than the input.
    std::vector<std::byte> compressed(records.size() + records.size() / 100 + 600);
    unsigned size = bzip2_size(compressed.size());
    auto* const in = const_cast<char*>(reinterpret_cast<const char*>(records.data()));  // NOLINT(*-const-cast)
    const int code = BZ2_bzBuffToBuffCompress(reinterpret_cast<char*>(compressed.data()), &size, in,
                                              bzip2_size(records.size()), 9, 0, 0);
    if (code != BZ_OK) {
        throw Error("bzip2: cannot compress " + std::to_string(records.size()) + " bytes");
    }
    compressed.resize(size);
    return compressed;
}

}  // namespace

Compression compression_of_start(std::span<const std::byte> start) {
    struct Magic {
        std::string_view bytes;
        Compression compression;
    };
    constexpr std::array<Magic, 4> known{{{"\x1f\x8b\x08", Compression::gzip},
                                          {"BZh", Compression::bzip2},
                                          {"\x28\xb5\x2f\xfd", Compression::zstd},
                                          {"\x04\x22\x4d\x18", Compression::lz4}}};
    const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
    const auto* const found =
        std::ranges::find_if(known, [&](const Magic& one) { return text.starts_with(one.bytes); });
    return found == known.end() ? Compression::none : found->compression;
}

std::string_view name_of(Compression compression) {
    constexpr std::array<std::string_view, 5> names{"", "lz4", "zstd", "bzip2", "gzip"};
    return names.at(static_cast<std::size_t>(compression));
}

std::unique_ptr<Decoder> make_decoder(Compression compression) {
    switch (compression) {
        case Compression::lz4:
            return std::make_unique<Lz4Decoder>();
        case Compression::zstd:
            return std::make_unique<ZstdDecoder>();
        case Compression::bzip2:
            return std::make_unique<Bzip2Decoder>();
        case Compression::gzip:
            return std::make_unique<GzipDecoder>();
        case Compression::none:
            break;
    }
    throw Error("there is nothing to decompress");
}

std::vector<std::byte> compress(Compression compression, std::span<const std::byte> records) {
    switch (compression) {
        case Compression::lz4:
            return compress_lz4(records);
        case Compression::zstd:
            return compress_zstd(records);
        case Compression::bzip2:
            return compress_bzip2(records);
        case Compression::gzip:
            throw Error("gzip: is read only; expected lz4, zstd or bzip2");
        case Compression::none:
            break;
    }
    return {records.begin(), records.end()};
}

Decompressed decompress(Compression compression, std::span<const std::byte> compressed, std::uint64_t expected_size,
                        std::vector<std::byte>& buffer) {
    if (compression != Compression::none) {
        return decoded_by(*make_decoder(compression), compressed, expected_size, buffer);
    }
    return {compressed, compressed.size() == expected_size ? "" : size_failure(compressed.size(), expected_size)};
}

}  // namespace ddtool

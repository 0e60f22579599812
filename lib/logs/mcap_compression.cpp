#include "logs/mcap_compression.hpp"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <memory>

#include "base/error.hpp"

namespace ddtool {
namespace {

constexpr std::size_t first_buffer_bytes = std::size_t{64} << 10;

/// One step of a decoder: how much it took and gave, and what it calls an error.
struct Step {
    std::size_t taken = 0;
    std::size_t given = 0;
    std::string error;
};

class Lz4Decoder {
public:
    Lz4Decoder() {
        LZ4F_dctx* context = nullptr;
        if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0U) {
            throw Error("lz4: out of memory");
        }
        context_.reset(context);
    }

    Step step(std::span<const std::byte> in, std::span<std::byte> out) {
        std::size_t taken = in.size();
        std::size_t given = out.size();
        const std::size_t result = LZ4F_decompress(context_.get(), out.data(), &given, in.data(), &taken, nullptr);
        return {taken, given, LZ4F_isError(result) != 0U ? LZ4F_getErrorName(result) : ""};
    }

private:
    struct Free {
        void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
    };
    std::unique_ptr<LZ4F_dctx, Free> context_;
};

class ZstdDecoder {
public:
    Step step(std::span<const std::byte> in, std::span<std::byte> out) {
        ZSTD_inBuffer input{in.data(), in.size(), 0};
        ZSTD_outBuffer output{out.data(), out.size(), 0};
        const std::size_t result = ZSTD_decompressStream(context_.get(), &output, &input);
        return {input.pos, output.pos, ZSTD_isError(result) != 0U ? ZSTD_getErrorName(result) : ""};
    }

private:
    struct Free {
        void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
    };
    std::unique_ptr<ZSTD_DCtx, Free> context_{ZSTD_createDCtx()};
};

/// Room after the first `used` bytes, at most up to `limit`; doubles the buffer when there is none.
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

template <typename Decoder>
Decompressed decode(Decoder decoder, std::span<const std::byte> in, std::uint64_t expected_size,
                    std::vector<std::byte>& buffer) {
    // One byte more than expected, so that an input which gives too much is seen to do so.
    const auto limit = static_cast<std::size_t>(expected_size) + 1;
    std::size_t used = 0;
    std::string failure;
    while (failure.empty() && used < limit) {
        const Step step = decoder.step(in, room(buffer, used, limit));
        in = in.subspan(step.taken);
        used += step.given;
        failure = step.error;
        if (step.taken == 0 && step.given == 0) {
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

}  // namespace

std::string_view mcap_compression_name(McapCompression compression) {
    switch (compression) {
        case McapCompression::lz4:
            return "lz4";
        case McapCompression::zstd:
            return "zstd";
        case McapCompression::none:
            break;
    }
    return "";
}

std::optional<McapCompression> mcap_compression_of(std::string_view name) {
    for (const auto compression : {McapCompression::none, McapCompression::lz4, McapCompression::zstd}) {
        if (name == mcap_compression_name(compression)) {
            return compression;
        }
    }
    return std::nullopt;
}

std::vector<std::byte> compress(McapCompression compression, std::span<const std::byte> records) {
    switch (compression) {
        case McapCompression::lz4:
            return compress_lz4(records);
        case McapCompression::zstd:
            return compress_zstd(records);
        case McapCompression::none:
            break;
    }
    return {records.begin(), records.end()};
}

Decompressed decompress(McapCompression compression, std::span<const std::byte> compressed, std::uint64_t expected_size,
                        std::vector<std::byte>& buffer) {
    switch (compression) {
        case McapCompression::lz4:
            return decode(Lz4Decoder(), compressed, expected_size, buffer);
        case McapCompression::zstd:
            return decode(ZstdDecoder(), compressed, expected_size, buffer);
        case McapCompression::none:
            break;
    }
    return {compressed, compressed.size() == expected_size ? "" : size_failure(compressed.size(), expected_size)};
}

}  // namespace ddtool

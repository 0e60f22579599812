#include "logs/containers/log_file.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "ddtool/base/error.hpp"
#include "logs/containers/compression.hpp"
#include "logs/containers/tar_reader.hpp"

namespace ddtool {
namespace {

constexpr std::size_t layer_bytes = std::size_t{1} << 16;

/// The decompressed content of a source: one frame after the other, as parallel compressors write them, too.
class UnpackingBuffer : public LayerBuffer {
public:
    UnpackingBuffer(ByteSource packed, Compression compression, LogProblemHandler on_problem)
        : packed_(std::move(packed)),
          compression_(compression),
          on_problem_(std::move(on_problem)),
          decoder_(make_decoder(compression)) {}

    [[nodiscard]] double fraction_read() const override { return packed_.fraction_read(); }

protected:
    int_type underflow() override {
        std::size_t given = 0;
        while (given == 0 && decoder_ != nullptr) {
            refill();
            given = decode();
        }
        auto* const begin = reinterpret_cast<char*>(out_.data());
        setg(begin, begin, begin + given);
        return given == 0 ? traits_type::eof() : traits_type::to_int_type(*begin);
    }

private:
    /// Reads on if everything has been decoded.
    void refill() {
        if (rest_.empty()) {
            rest_ = std::span(in_).first(packed_.read(in_));
        }
    }

    std::size_t decode() {
        if (rest_.empty() && between_frames_) {
            decoder_.reset();
            return 0;
        }
        if (between_frames_ && !begin_frame()) {
            return 0;
        }
        const bool is_end = rest_.empty();
        const Decoder::Step step = decoder_->step(rest_, out_);
        rest_ = rest_.subspan(step.taken);
        between_frames_ = step.ended;
        if (!step.error.empty() || (is_end && step.given == 0 && !step.ended)) {
            end("cut off or damaged near");
        }
        return step.given;
    }

    /// Makes a decoder for the frame that follows. Returns false if something else follows.
    bool begin_frame() {
        while (rest_.size() < 4) {  // the first bytes of a frame may be on both sides of what was read
            std::ranges::copy(rest_, in_.begin());
            const std::size_t count = packed_.read(std::span(in_).subspan(rest_.size()));
            rest_ = std::span(in_).first(rest_.size() + count);
            if (count == 0) {
                break;
            }
        }
        // A frame to be skipped is the same in zstd and lz4; their decoders know it.
        const bool is_skippable = (compression_ == Compression::zstd || compression_ == Compression::lz4) &&
                                  rest_.size() >= 4 && (rest_[0] & std::byte{0xF0}) == std::byte{0x50} &&
                                  rest_[1] == std::byte{0x2A} && rest_[2] == std::byte{0x4D} &&
                                  rest_[3] == std::byte{0x18};
        if (!is_skippable && compression_of_start(rest_) != compression_) {
            end("followed by something else near");
            return false;
        }
        decoder_ = make_decoder(compression_);
        between_frames_ = false;
        return true;
    }

    void end(const std::string& what) {
        const std::uint64_t offset = packed_.offset() - rest_.size();
        const std::uint64_t left = packed_.remaining().value_or(0) + rest_.size();
        decoder_.reset();
        on_problem_({packed_.name() + ": " + std::string(name_of(compression_)) + " data " + what + " byte " +
                         std::to_string(offset) + "; the rest cannot be read",
                     offset, left});
    }

    ByteSource packed_;
    Compression compression_;
    LogProblemHandler on_problem_;
    std::unique_ptr<Decoder> decoder_;  ///< null after the end
    bool between_frames_ = false;
    std::vector<std::byte> in_ = std::vector<std::byte>(layer_bytes);
    std::vector<std::byte> out_ = std::vector<std::byte>(layer_bytes);
    std::span<std::byte> rest_;  ///< of in_, not yet decoded
};

/// One file of a tar archive.
class TarEntryBuffer : public LayerBuffer {
public:
    TarEntryBuffer(TarReader tar, std::string name, LogProblemHandler on_problem)
        : tar_(std::move(tar)), name_(std::move(name)), on_problem_(std::move(on_problem)) {}

    [[nodiscard]] double fraction_read() const override { return tar_.fraction_read(); }

protected:
    int_type underflow() override {
        const std::size_t count = tar_.read(bytes_);
        if (tar_.is_cut_off() && !std::exchange(told_, true)) {
            on_problem_({name_ + ": the archive is cut off within this file"});
        }
        auto* const begin = reinterpret_cast<char*>(bytes_.data());
        setg(begin, begin, begin + count);
        return count == 0 ? traits_type::eof() : traits_type::to_int_type(*begin);
    }

private:
    TarReader tar_;
    std::string name_;
    LogProblemHandler on_problem_;
    bool told_ = false;
    std::vector<std::byte> bytes_ = std::vector<std::byte>(layer_bytes);
};

ByteSource unpacked_bytes(ByteSource source, const LogProblemHandler& on_problem) {
    for (int layer = 0; layer < most_layers; ++layer) {
        const Compression compression = compression_of_start(source.start(4));
        if (compression == Compression::none) {
            break;
        }
        const std::string name = source.name();
        source = ByteSource(std::make_unique<UnpackingBuffer>(std::move(source), compression, on_problem), name);
    }
    return source;
}

}  // namespace

ByteSource open_bytes(const LogFile& file, const LogProblemHandler& on_problem) {
    ByteSource bytes = unpacked_bytes(ByteSource(file.path), on_problem);
    if (file.entry.empty()) {
        return bytes;
    }
    TarReader tar(std::move(bytes));
    while (const auto entry = tar.next()) {
        if (entry->name == file.entry) {
            auto content = std::make_unique<TarEntryBuffer>(std::move(tar), file.name(), on_problem);
            return unpacked_bytes(ByteSource(std::move(content), file.name()), on_problem);
        }
    }
    throw Error(file.name() + ": cannot open: the archive has no such file");
}

void visit_archive(const std::filesystem::path& path,
                   const std::function<void(const LogFile&, std::span<const std::byte>)>& visit) {
    TarReader tar(open_bytes({path, ""}, {}));
    std::string start;
    while (const auto entry = tar.next()) {
        start.resize(layer_bytes);
        start.resize(tar.read(std::as_writable_bytes(std::span(start))));
        const LogFile file{path, entry->name};
        ByteSource content = unpacked_bytes(ByteSource(std::make_unique<std::istringstream>(start), file.name()), {});
        visit(file, content.start(layer_bytes));
    }
}

}  // namespace ddtool

#include "logs/containers/byte_source.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "ddtool/base/error.hpp"
#include "system/crc.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

constexpr std::uint64_t step_bytes = std::uint64_t{1} << 20;

std::unique_ptr<std::istream> open_stream(const std::filesystem::path& path) {
    std::error_code unknown;
    const std::filesystem::file_type type = std::filesystem::status(path, unknown).type();
    // A log is opened more than once, and to open a pipe waits for who writes into it.
    if (type == std::filesystem::file_type::fifo || type == std::filesystem::file_type::character ||
        type == std::filesystem::file_type::socket) {
        throw Error(path.string() +
                    ": cannot read: it is a pipe or a device, which can be read only once; a file was "
                    "expected, or MCAP on standard input with --log -");
    }
    errno = 0;
    auto stream = std::make_unique<std::ifstream>(path, std::ios::binary);
    if (!*stream) {
        throw Error(path.string() + ": cannot read: " + std::strerror(errno));
    }
    if (is_folder(path)) {
        throw Error(path.string() + ": cannot read: it is a folder, a file was expected");
    }
    return stream;
}

std::optional<std::uint64_t> size_of(const std::filesystem::path& path) {
    std::error_code unknown;
    const bool regular = std::filesystem::is_regular_file(path, unknown);
    return regular ? std::optional(std::filesystem::file_size(path)) : std::nullopt;
}

}  // namespace

ByteSource::ByteSource(const std::filesystem::path& path) : ByteSource(open_stream(path), path.string()) {
    size_ = size_of(path);
}

ByteSource::ByteSource(std::unique_ptr<std::istream> stream, std::string name)
    : stream_(std::move(stream)), name_(std::move(name)) {}

ByteSource::ByteSource(std::unique_ptr<LiveBuffer> live, std::string name)
    : live_(std::move(live)), stream_(std::make_unique<std::istream>(live_.get())), name_(std::move(name)) {}

ByteSource::ByteSource(std::unique_ptr<LayerBuffer> layer, std::string name)
    : layer_(std::move(layer)), stream_(std::make_unique<std::istream>(layer_.get())), name_(std::move(name)) {}

void ByteSource::wait_no_more() {
    if (live_) {
        live_->wait_no_more();
    }
}

std::span<const std::byte> ByteSource::start(std::size_t size) {
    const std::size_t before = start_.size();
    if (before < size) {
        start_.resize(size);
        start_.resize(before + read_stream(std::span(start_).subspan(before)));
    }
    return std::span(start_).first(std::min(size, start_.size()));
}

std::size_t ByteSource::read(std::span<std::byte> into) {
    const std::size_t known = std::min(start_.size(), into.size());
    std::copy_n(start_.begin(), known, into.begin());
    start_.erase(start_.begin(), start_.begin() + static_cast<std::ptrdiff_t>(known));
    const std::size_t count = known + (known < into.size() ? read_stream(into.subspan(known)) : 0);
    crc_ = crc32_of(into.first(count), crc_);
    offset_ += count;
    return count;
}

std::size_t ByteSource::read_stream(std::span<std::byte> into) {
    stream_->read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(into.size()));
    if (stream_->bad()) {
        throw Error(name_ + ": cannot read after byte " + std::to_string(offset_) + ": " + std::strerror(errno));
    }
    return static_cast<std::size_t>(stream_->gcount());
}

std::uint64_t ByteSource::append_to(std::vector<std::byte>& into, std::uint64_t size) {
    std::uint64_t appended = 0;
    while (appended < size) {
        const std::size_t before = into.size();
        const auto wanted = static_cast<std::size_t>(std::min(size - appended, step_bytes));
        into.resize(before + wanted);
        const std::size_t count = read(std::span(into).subspan(before));
        into.resize(before + count);
        appended += count;
        if (count < wanted) {
            break;
        }
    }
    return appended;
}

std::uint64_t ByteSource::skip(std::uint64_t size) {
    std::array<std::byte, 65536> discarded;
    std::uint64_t skipped = 0;
    while (skipped < size) {
        const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(size - skipped, discarded.size()));
        const std::size_t count = read(std::span(discarded).first(wanted));
        skipped += count;
        if (count < wanted) {
            break;
        }
    }
    return skipped;
}

std::optional<std::uint64_t> ByteSource::remaining() const {
    return size_ ? std::optional(*size_ > offset_ ? *size_ - offset_ : 0) : std::nullopt;
}

double ByteSource::fraction_read() const {
    if (layer_) {
        return layer_->fraction_read();
    }
    if (!size_) {
        return 0.0;
    }
    return *size_ == 0 ? 1.0 : std::min(1.0, static_cast<double>(offset_) / static_cast<double>(*size_));
}

}  // namespace ddtool

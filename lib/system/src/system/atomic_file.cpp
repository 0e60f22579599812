#include "system/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <utility>

namespace ddtool {
namespace {

std::string failure(const std::filesystem::path& path, const char* doing) {
    // errno is 0 if the stream failed for a reason other than a failed system call.
    return path.string() + ": cannot " + doing + (errno == 0 ? "" : std::string(": ") + std::strerror(errno));
}

[[noreturn]] void fail_to(const std::filesystem::path& path, const char* doing) {
    throw OutputError(failure(path, doing));
}

void sync_to_disk(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) {
        fail_to(path, "open");
    }
    const int result = ::fsync(file);
    ::close(file);
    if (result != 0) {
        fail_to(path, "write");
    }
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path path) : path_(std::move(path)), part_(path_.string() + ".part") {
    std::error_code ignored;
    const std::filesystem::file_status there = std::filesystem::status(path_, ignored);
    if (std::filesystem::is_other(there)) {
        throw OutputError(
            path_.string() +
            ": is a device, a pipe or a socket, which a file cannot replace; expected the name of a file");
    }
    std::filesystem::remove(part_, ignored);
}

AtomicFile::~AtomicFile() {
    if (!committed_) {
        std::error_code ignored;
        std::filesystem::remove(part_, ignored);
    }
}

void AtomicFile::commit() {
    sync_to_disk(part_);
    if (::rename(part_.c_str(), path_.c_str()) != 0) {
        fail_to(path_, "rename its .part to it");
    }
    committed_ = true;
}

AtomicStream::AtomicStream(const std::filesystem::path& path) : path_(path), file_(path) {
    errno = 0;
    stream_.open(file_.part(), std::ios::binary);
    if (!stream_) {
        fail_to(path_, "create");
    }
}

void AtomicStream::close() {
    stream_.close();
    expect_written();
    file_.commit();
}

void AtomicStream::expect_written() const {
    if (!stream_) {
        fail_to(path_, "write");
    }
}

void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
    AtomicStream file(path);
    file.write(write);
    file.close();
}

void write_file(const std::filesystem::path& path, std::string_view content) {
    write_file(path,
               [&](std::ostream& out) { out.write(content.data(), static_cast<std::streamsize>(content.size())); });
}

std::string read_file(const std::filesystem::path& path) {
    errno = 0;
    std::ifstream stream(path, std::ios::binary);
    if (!stream) {
        throw Error(failure(path, "read"));
    }
    // errno alone tells nothing: what succeeds may leave something in it, as an allocation does that finds another
    // place.
    std::string content;
    std::array<char, std::size_t{1} << 16U> block;
    do {
        stream.read(block.data(), block.size());
        content.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    } while (stream);
    if (stream.bad()) {  // opening a folder succeeds, but reading it fails
        throw Error(failure(path, "read"));
    }
    return content;
}

}  // namespace ddtool

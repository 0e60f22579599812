#include "logs/containers/live_buffer.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <ios>
#include <memory>
#include <thread>
#include <utility>

#include "ddtool/base/error.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

constexpr int wait_ms = 50;
constexpr std::size_t live_buffer_bytes = 1 << 16;

/// Waits for input, but only up to wait_ms, so that a read does not block for long. Returns whether there is any.
bool readable(int descriptor) {
    pollfd request{descriptor, POLLIN, 0};
    return ::poll(&request, 1, wait_ms) > 0;
}

}  // namespace

std::unique_ptr<LiveBuffer> LiveBuffer::standard_input(Stop stop) {
    return std::unique_ptr<LiveBuffer>(new LiveBuffer(STDIN_FILENO, false, false, std::move(stop)));
}

std::unique_ptr<LiveBuffer> LiveBuffer::followed(const std::filesystem::path& path, Stop stop) {
    if (is_folder(path)) {
        throw Error(path.string() + ": is a folder; expected the MCAP file in it that is being written");
    }
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0) {
        throw Error(path.string() + ": cannot read: " + std::strerror(errno));
    }
    return std::unique_ptr<LiveBuffer>(new LiveBuffer(descriptor, true, true, std::move(stop)));
}

LiveBuffer::LiveBuffer(int descriptor, bool owned, bool grows, Stop stop)
    : descriptor_(descriptor), owned_(owned), grows_(grows), stop_(std::move(stop)), bytes_(live_buffer_bytes) {}

LiveBuffer::~LiveBuffer() {
    if (owned_) {
        ::close(descriptor_);
    }
}

LiveBuffer::int_type LiveBuffer::underflow() {
    while (!stop_()) {
        if (!readable(descriptor_)) {
            continue;
        }
        const ssize_t count = ::read(descriptor_, bytes_.data(), bytes_.size());
        if (count > 0) {
            setg(bytes_.data(), bytes_.data(), bytes_.data() + count);
            return traits_type::to_int_type(bytes_.front());
        }
        if (count < 0 && errno != EINTR && errno != EAGAIN) {
            throw std::ios_base::failure("cannot read");  // sets badbit in the stream that reads from this
        }
        if (count == 0 && !grows_) {
            break;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(count == 0 ? wait_ms : 0));
    }
    return traits_type::eof();
}

}  // namespace ddtool

#include "logs/containers/temporary_copy.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <string>
#include <system_error>
#include <vector>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr std::size_t copied_bytes = std::size_t{1} << 20;

bool write_fully(int descriptor, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::write(descriptor, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR) {
            return false;
        }
        bytes = bytes.subspan(count < 0 ? 0 : static_cast<std::size_t>(count));
    }
    return true;
}

}  // namespace

TemporaryCopy::TemporaryCopy(ByteSource source) {
    std::error_code failure;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(failure);
    std::string name = ((failure ? "/tmp" : folder) / "ddtool-XXXXXX").string();
    const int descriptor = ::mkstemp(name.data());
    bool written = descriptor >= 0;
    if (written) {
        path_ = name;
        try {
            std::vector<std::byte> bytes(copied_bytes);
            for (std::size_t count = bytes.size(); written && count == bytes.size();) {
                count = source.read(bytes);
                written = write_fully(descriptor, std::span(bytes).first(count));
            }
        } catch (...) {
            ::close(descriptor);
            remove();
            throw;
        }
    }
    const std::string reason = std::strerror(errno);
    if (descriptor >= 0) {
        ::close(descriptor);
    }
    if (!written) {
        remove();
        throw Error(source.name() + ": cannot be unpacked into " + name + ": " + reason +
                    "; TMPDIR names the folder for such files");
    }
}

void TemporaryCopy::remove() {
    if (!path_.empty()) {
        std::error_code ignored;
        std::filesystem::remove(path_, ignored);
        path_.clear();
    }
}

}  // namespace ddtool

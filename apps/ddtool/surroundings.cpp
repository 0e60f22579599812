#include "surroundings.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <iostream>
#include <string>
#include <string_view>

namespace ddtool {
namespace {

void end_by_bus_error(int /*signal*/) {
    constexpr std::string_view line =
        "ddtool: error: SIGBUS: an input file became shorter while it was read, or its disk failed\n";
    [[maybe_unused]] const auto written = ::write(STDERR_FILENO, line.data(), line.size());
    ::_exit(static_cast<int>(ExitCode::failed));
}

bool memory_is_limited() {
    rlimit limit{};
    return ::getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
}

}  // namespace

void reserve_standard_descriptors() {
    for (int descriptor = STDIN_FILENO; descriptor <= STDERR_FILENO; ++descriptor) {
        if (::fcntl(descriptor, F_GETFD) < 0) {  // open() takes the lowest free number, which is this one
            ::open("/dev/null", descriptor == STDIN_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

void explain_bus_errors() { std::signal(SIGBUS, end_by_bus_error); }

void flush_results() {
    if (std::cout.flush()) {
        return;
    }
    std::cout.clear();
    errno = 0;
    std::cout.put('\n').flush();  // writes again, to learn the reason: the failure before may not have left it in errno
    throw Error("standard output: cannot write the results" +
                (errno == 0 ? "" : std::string(": ") + std::strerror(errno)));
}

void expect_memory_for_libtorch() {
    constexpr std::size_t needed_bytes = std::size_t{512} << 20U;
    if (!memory_is_limited()) {
        return;
    }
    void* const room = ::mmap(nullptr, needed_bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) {
        throw Error("not enough memory: the limit (ulimit -v) leaves less than 512 MiB for LibTorch to work with");
    }
    ::munmap(room, needed_bytes);
}

int exit_status(ExitCode code) {
    if (memory_is_limited()) {
        ::_exit(static_cast<int>(code));
    }
    return static_cast<int>(code);
}

}  // namespace ddtool

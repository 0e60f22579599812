#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "ddtool/base/error.hpp"
#include "engine_provider.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

/// This process's arguments from the content of /proc/self/cmdline, where each ends with a zero byte (proc(5)).
std::vector<char*> arguments_in(std::string& command_line) {
    std::vector<char*> arguments;
    for (std::size_t place = 0; place < command_line.size(); place = command_line.find('\0', place) + 1) {
        arguments.push_back(&command_line[place]);
    }
    arguments.push_back(nullptr);
    return arguments;
}

}  // namespace

const train::Engine& provide_engine() {
    const std::filesystem::path program =
        std::filesystem::read_symlink("/proc/self/exe").parent_path() / "ddtool-torch";
    std::string command_line = read_file("/proc/self/cmdline");
    execv(program.c_str(), arguments_in(command_line).data());
    if (errno == ENOENT) {
        throw Error("this needs LibTorch, and " + program.string() +
                    " is not there: scripts/build makes it, the Debian package ddtool-torch installs it");
    }
    throw Error(program.string() +
                ": cannot be started, which this needs for LibTorch: " + std::generic_category().message(errno));
}

}  // namespace ddtool

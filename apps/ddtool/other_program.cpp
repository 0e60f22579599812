#include "other_program.hpp"

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <vector>

#include "ddtool/base/error.hpp"
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

void become_other_program(const std::string& program, const std::string& library) {
    const std::filesystem::path path = std::filesystem::read_symlink("/proc/self/exe").parent_path() / program;
    std::string command_line = read_file("/proc/self/cmdline");
    execv(path.c_str(), arguments_in(command_line).data());
    if (errno == ENOENT) {
        throw Error("this needs " + library + ", and " + path.string() + " is not there: scripts/build " + program +
                    " makes it, the Debian package " + program + " installs it");
    }
    throw Error(path.string() + ": cannot be started, which this needs for " + library + ": " +
                std::generic_category().message(errno));
}

}  // namespace ddtool

#pragma once

#include <string>

namespace ddtool {

/// Starts another program, from the folder of this one, in place of this process and with the same arguments.
/// \param program its name, which is also that of the Debian package that has it
/// \param library what it has and this one has not
/// Throws Error if that is not possible, naming the library that is lacking.
[[noreturn]] void become_other_program(const std::string& program, const std::string& library);

}  // namespace ddtool

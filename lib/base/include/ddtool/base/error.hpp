#pragma once

#include <stdexcept>
#include <string>

namespace ddtool {

/// The program's exit status (docs/command-line.md).
enum class ExitCode : int {
    done = 0,
    failed = 1,
    usage = 2,           ///< wrong arguments or configuration
    done_with_loss = 3,  ///< finished, but something was skipped; the output says what and how many
};

/// What ends a command. The text is one line: what, where (file, offset, message, key), what was expected.
/// Caught once, in main.
class Error : public std::runtime_error {
public:
    explicit Error(const std::string& what, ExitCode code = ExitCode::failed);
    [[nodiscard]] ExitCode code() const noexcept { return code_; }

private:
    ExitCode code_;
};

/// Wrong arguments or configuration: ends the command with ExitCode::usage.
class UsageError : public Error {
public:
    explicit UsageError(const std::string& what);
};

}  // namespace ddtool

#include "ddtool/base/error.hpp"

namespace ddtool {

Error::Error(const std::string& what, ExitCode code) : std::runtime_error(what), code_(code) {}

UsageError::UsageError(const std::string& what) : Error(what, ExitCode::usage) {}

}  // namespace ddtool

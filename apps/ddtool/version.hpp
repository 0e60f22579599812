#pragma once

#include <string>

namespace ddtool {

/// Version, commit, compiler and the versions of the libraries it was built with, a line each.
std::string version_text();

}  // namespace ddtool

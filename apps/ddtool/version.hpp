#pragma once

#include <string>
#include <vector>

namespace ddtool {

struct Version {
    std::string name;
    std::string number;
};

/// ddtool's version and commit first, then the compiler and the libraries it was built with.
std::vector<Version> versions();

/// ddtool's own, to say which build computed something.
std::string program_version();

/// All of them, a line each, for --version.
std::string version_text();

}  // namespace ddtool

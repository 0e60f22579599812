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

/// The same, a line each, for --version.
std::string version_text();

}  // namespace ddtool

#pragma once

#include <string>
#include <vector>

namespace ddtool {

struct Version {
    std::string name;
    std::string number;
};

/// The versions of ddtool (with its commit), of the compiler, and of the libraries that it was built with, in this
/// order.
std::vector<Version> versions();

/// ddtool's own version, which is stored with results to identify the build that computed them.
std::string program_version();

/// All versions, one per line, for --version.
std::string version_text();

}  // namespace ddtool

#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace ddtool {

/// The manual page, section 1, of the program (`app` has no parent) or of one of its commands, in man(7)'s macros.
std::string man_page(const CLI::App& app);

/// "ddtool" or "ddtool-COMMAND".
std::string man_page_name(const CLI::App& app);

}  // namespace ddtool

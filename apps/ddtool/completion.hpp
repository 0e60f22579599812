#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace ddtool {

/// Completion of commands, options and values, as a script for bash or zsh (which runs bash's). Values follow from an
/// option's type in --help: a|b|c are choices, FILE and DIR are names of files and folders.
std::string bash_completion(const CLI::App& program);
std::string zsh_completion(const CLI::App& program);

}  // namespace ddtool

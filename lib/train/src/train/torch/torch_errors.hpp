#pragma once

#include <torch/torch.h>

#include <filesystem>
#include <string>
#include <string_view>

#include "ddtool/base/error.hpp"

namespace ddtool::train_torch {

/// Turns an exception of LibTorch into an Error of one line: the file, what it should have been, and the first line of
/// LibTorch's message. The rest of the message is a backtrace or, for TorchScript, the source.
inline Error error_of_torch(const std::filesystem::path& path, const std::string& expected,
                            const std::exception& error) {
    constexpr std::size_t most = 200;
    const auto* const own = dynamic_cast<const c10::Error*>(&error);
    const std::string_view text = own != nullptr ? own->what_without_backtrace() : error.what();
    const std::size_t start = std::min(text.find_first_not_of('\n'), text.size());
    return Error(path.string() + ": " + expected + ": " +
                 std::string(text.substr(start, std::min(most, text.find('\n', start) - start))));
}

/// Runs an action that reads a file with LibTorch. Exceptions of LibTorch become Error by error_of_torch(); an Error
/// passes through unchanged.
template <typename Action>
auto guarded_by_path(const std::filesystem::path& path, const std::string& expected, Action&& action) {
    try {
        return action();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& error) {
        throw error_of_torch(path, expected, error);
    }
}

}  // namespace ddtool::train_torch

#include "system/failure_text.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

namespace ddtool {
namespace {

/// Parts of the messages by which OpenCV, LibTorch and oneTBB report a shortage of memory. oneTBB fails to start a
/// thread, because there is no memory for its stack.
constexpr std::array<std::string_view, 3> words_for_short_memory{"(-4:Insufficient memory)", "can't allocate memory",
                                                                 "pthread_create has failed"};

bool tells_of_short_memory(const std::exception& failure) {
    const std::string_view text = failure.what();
    return dynamic_cast<const std::bad_alloc*>(&failure) != nullptr ||
           std::ranges::any_of(words_for_short_memory,
                               [&](std::string_view words) { return text.find(words) != std::string_view::npos; });
}

}  // namespace

std::string failure_text(const std::exception& failure) {
    if (tells_of_short_memory(failure)) {
        return "not enough memory: the system, or a limit (ulimit -v), gives no more";
    }
    const std::string text = failure.what();
    return text.substr(0, text.find('\n'));
}

}  // namespace ddtool

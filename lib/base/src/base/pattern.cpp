#include "base/pattern.hpp"

#include <algorithm>

namespace ddtool {
namespace {

constexpr const char* safe_characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";

void replace_all(std::string& text, const std::string& what, const std::string& by) {
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
        text.replace(at, what.size(), by);
    }
}

}  // namespace

std::string expand(std::string text, const std::string& world, std::uint64_t seed) {
    replace_all(text, "{world}", world);
    replace_all(text, "{seed}", std::to_string(seed));
    return text;
}

std::string file_name_of(const std::string& name) {
    std::string safe = name;
    for (std::size_t at = 0; (at = safe.find_first_not_of(safe_characters, at)) != std::string::npos;) {
        safe[at] = '_';
    }
    return safe;
}

}  // namespace ddtool

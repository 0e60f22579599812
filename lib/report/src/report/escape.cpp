#include "report/escape.hpp"

namespace ddtool::report {
namespace {

std::string_view reference_of(char c) {
    switch (c) {
        case '&':
            return "&amp;";
        case '<':
            return "&lt;";
        case '>':
            return "&gt;";
        case '"':
            return "&quot;";
        case '\'':
            return "&#39;";
        default:
            return {};
    }
}

}  // namespace

std::string html_escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        const std::string_view reference = reference_of(c);
        result += reference.empty() ? std::string_view(&c, 1) : reference;
    }
    return result;
}

std::string script_json(const Json& value) {
    std::string result;
    for (const char c : value.dump(-1, ' ', false, Json::error_handler_t::replace)) {
        if (c == '<') {
            result += "\\u003c";
        } else {
            result += c;
        }
    }
    return result;
}

}  // namespace ddtool::report

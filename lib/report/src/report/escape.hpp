#pragma once

#include <string>
#include <string_view>

#include "ddtool/system/settings.hpp"

namespace ddtool::html {

/// The text as HTML shows it, in an element or a quoted attribute.
std::string escaped(std::string_view text);

/// JSON for a script element, which nothing in it can end: '<' is written as \u003c. Bytes that are not UTF-8, as a
/// file's name may have, become the replacement character.
std::string script_json(const Json& value);

}  // namespace ddtool::html

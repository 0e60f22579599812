#pragma once

#include <string>
#include <string_view>

#include "ddtool/system/settings.hpp"

namespace ddtool::report {

/// The text escaped for HTML, in an element or a quoted attribute.
std::string html_escaped(std::string_view text);

/// JSON for a script element. Nothing in it can end the element, because '<' is written as \u003c. Bytes that are not
/// UTF-8, which a file name may contain, become the replacement character.
std::string script_json(const Json& value);

}  // namespace ddtool::report

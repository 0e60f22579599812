#pragma once

#include <string>
#include <string_view>

namespace ddtool::report {

/// The style sheet of every page (CSS).
std::string_view style_sheet();

/// The script of a page's explorer (JavaScript). It ends with the call that starts it.
std::string explorer_script();

}  // namespace ddtool::report

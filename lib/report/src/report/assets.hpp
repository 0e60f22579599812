#pragma once

#include <string>
#include <string_view>

namespace ddtool::html {

/// What every page looks like.
std::string_view style_sheet();

/// What makes a page's explorer live: ends in the call that starts it.
std::string explorer_script();

}  // namespace ddtool::html

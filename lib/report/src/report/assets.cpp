#include "report/assets.hpp"

#include "system/embedded_file.hpp"

DDTOOL_EMBED_FILE(ddtool_page_css, DDTOOL_PAGE_ASSETS "/page.css");
DDTOOL_EMBED_FILE(ddtool_map_view_js, DDTOOL_PAGE_ASSETS "/map_view.js");
DDTOOL_EMBED_FILE(ddtool_time_lines_js, DDTOOL_PAGE_ASSETS "/time_lines.js");
DDTOOL_EMBED_FILE(ddtool_explorer_js, DDTOOL_PAGE_ASSETS "/explorer.js");

namespace ddtool::report {
namespace {

std::string_view between(const char* begin, const char* end) { return {begin, static_cast<std::size_t>(end - begin)}; }

}  // namespace

std::string_view style_sheet() { return between(ddtool_page_css, ddtool_page_css_end); }

std::string explorer_script() {
    std::string script;
    script += between(ddtool_map_view_js, ddtool_map_view_js_end);
    script += between(ddtool_time_lines_js, ddtool_time_lines_js_end);
    script += between(ddtool_explorer_js, ddtool_explorer_js_end);
    return script;
}

}  // namespace ddtool::report

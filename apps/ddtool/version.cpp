#include "version.hpp"

#include <CLI/Version.hpp>
#include <nlohmann/json.hpp>

namespace ddtool {

std::string version_text() {
    std::string text = "ddtool " DDTOOL_VERSION "\n";
    text += "CLI11 " CLI11_VERSION "\n";
    return text;
}

}  // namespace ddtool

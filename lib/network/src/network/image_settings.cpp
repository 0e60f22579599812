#include "ddtool/network/image_settings.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"
#include "system/expect.hpp"

namespace ddtool {
void to_json(Json& json, Swarm swarm) { json = swarm_names.at(static_cast<std::size_t>(swarm)); }

void from_json(const Json& json, Swarm& swarm) {
    const auto* const found =
        std::find_if(swarm_names.begin(), swarm_names.end(), [&](const char* name) { return json == name; });
    if (found == swarm_names.end()) {
        throw UsageError("swarm: expected absolute, step or response, not " + json.dump());
    }
    swarm = static_cast<Swarm>(found - swarm_names.begin());
}

void expect_valid(const ImageSettings& settings) {
    constexpr double smallest = 1e-6;
    constexpr double largest = 1e6;
    expect_between("size_px", static_cast<double>(settings.size_px), 1, 4096);
    expect_between("canvas_m", settings.canvas_m, smallest, largest);
    expect_between("step_canvas_spreads", settings.step_canvas_spreads, 0, largest);
    if (settings.swarm == Swarm::response && settings.step_canvas_spreads == 0.0) {
        throw UsageError("step_canvas_spreads: the response's canvas is of that size, so expected more than 0");
    }
    expect_between("step_canvas_min_m", settings.step_canvas_min_m, smallest, largest);
    expect_between("gaussian_sigma_px", settings.gaussian_sigma_px, smallest, largest);
    expect_between("gaussian_threshold", settings.gaussian_threshold, smallest, largest);
}

}  // namespace ddtool

#include "imaging/image_settings.hpp"

#include "base/error.hpp"
#include "base/expect.hpp"

namespace ddtool {
void to_json(Json& json, Swarm swarm) { json = swarm == Swarm::step ? "step" : "absolute"; }

void from_json(const Json& json, Swarm& swarm) {
    if (json != "absolute" && json != "step") {
        throw UsageError("swarm: expected absolute or step, not " + json.dump());
    }
    swarm = json == "step" ? Swarm::step : Swarm::absolute;
}

void expect_valid(const ImageSettings& settings) {
    constexpr double smallest = 1e-6;
    constexpr double largest = 1e6;
    expect_between("size_px", static_cast<double>(settings.size_px), 1, 4096);
    expect_between("canvas_m", settings.canvas_m, smallest, largest);
    expect_between("step_canvas_spreads", settings.step_canvas_spreads, 0, largest);
    expect_between("step_canvas_min_m", settings.step_canvas_min_m, smallest, largest);
    expect_between("gaussian_sigma_px", settings.gaussian_sigma_px, smallest, largest);
    expect_between("gaussian_threshold", settings.gaussian_threshold, smallest, largest);
}

}  // namespace ddtool

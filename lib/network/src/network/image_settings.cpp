#include "ddtool/network/image_settings.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"
#include "network/image_setting_rows.hpp"

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

const SettingTable<ImageSettings>& image_setting_rows() {
    using Image = ImageSettings;
    const Allowed size_m = Allowed::number(1e-6, 1e6);
    static const SettingTable<Image> rows{
        {"swarm", &Image::swarm, Allowed::one_of({swarm_names.begin(), swarm_names.end()}), "",
         "Which coordinates of the particles an image shows.", "docs/imaging.md"},
        {"size_px", &Image::size_px, Allowed::whole(1, 4096), "px", "Side of the square image.", "the paper's S"},
        {"canvas_m", &Image::canvas_m, size_m, "m", "Side of the canvas for the swarm absolute.", "the paper's s"},
        {"step_canvas_spreads", &Image::step_canvas_spreads, Allowed::number(0.0, 1e6), "",
         "Side of the canvas for the swarm step, in standard deviations of the motion that the odometry predicted; 0 "
         "gives every step the smallest canvas. For response it is the canvas itself."},
        {"step_canvas_min_m", &Image::step_canvas_min_m, size_m, "m",
         "No canvas for the swarms step and response is smaller."},
        {"linear_mapping", &Image::linear_mapping, Allowed::flag(), "",
         "Whether the canvas is scaled to the image; otherwise a coordinate in metres is a pixel, counted from the "
         "middle.",
         "the paper's ablation"},
        {"gaussian_augmentation", &Image::gaussian_augmentation, Allowed::flag(), "",
         "Whether a particle marks the pixels around its own, too.", "the paper's G"},
        {"gaussian_sigma_px", &Image::gaussian_sigma_px, size_m, "px", "Standard deviation of the Gaussian.",
         "the paper's G"},
        {"gaussian_threshold", &Image::gaussian_threshold, size_m, "1/px^2",
         "A pixel is marked where the sum of the Gaussians exceeds it."},
    };
    return rows;
}

void to_json(Json& json, const ImageSettings& settings) { json = image_setting_rows().json(settings); }

void from_json(const Json& json, ImageSettings& settings) { image_setting_rows().read(json, settings); }

void expect_valid(const ImageSettings& settings, const std::string& path) {
    expect_allowed(Json(settings), image_setting_rows().settings(), path);
    if (settings.swarm == Swarm::response && settings.step_canvas_spreads == 0.0) {
        throw UsageError((path.empty() ? "" : path + ".") +
                         "step_canvas_spreads: the response's canvas is of that size, so expected more than 0");
    }
}

}  // namespace ddtool

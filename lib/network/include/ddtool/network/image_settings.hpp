#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "ddtool/system/settings.hpp"

namespace ddtool {

/// Which coordinates of the particles an image shows.
enum class Swarm {
    absolute,  ///< x, y of the poses in the world: how far the particles' histories have drifted apart
    step,      ///< x, y of the matched motions in the robot's previous frame: what the scan leaves open now
    response,  ///< each particle's matched motion against its predicted one, along the weakest direction: response()
};

/// The names, in the order of Swarm.
inline constexpr std::array<const char*, 3> swarm_names{"absolute", "step", "response"};

/// Writes and reads "absolute", "step" or "response". Reading throws UsageError for any other word.
void to_json(Json& json, Swarm swarm);
void from_json(const Json& json, Swarm& swarm);

/// How a swarm becomes an image (docs/imaging.md). A model works only on images made in the same way as those it was
/// trained on.
struct ImageSettings {
    Swarm swarm = Swarm::absolute;
    std::size_t size_px = 224;  ///< S, the side of the square image
    double canvas_m = 10.0;     ///< s, the side of the canvas for the absolute swarm
    /// The side of the canvas for the step swarm, in standard deviations of the motion that the odometry predicted,
    /// along the major axis of the predictions. 0 gives every step the smallest canvas, step_canvas_min_m, and so a
    /// fixed size. For the response swarm, which is measured in such standard deviations, it is the side of the canvas
    /// itself.
    double step_canvas_spreads = 8.0;
    double step_canvas_min_m = 0.1;     ///< no canvas for the step swarm or the response is smaller
    bool linear_mapping = true;         ///< false: a coordinate in metres is a pixel index, counted from the middle
    bool gaussian_augmentation = true;  ///< false: a particle marks its own pixel and no other
    double gaussian_sigma_px = 1.0;     ///< sigma of G
    double gaussian_threshold = 0.02;   ///< a pixel whose sum of G (1/px^2) exceeds it is marked
};
void to_json(Json& json, const ImageSettings& settings);
void from_json(const Json& json, ImageSettings& settings);

/// Throws UsageError for an invalid value. The message names the setting, with `path` in front where that is not empty.
void expect_valid(const ImageSettings& settings, const std::string& path = "");

}  // namespace ddtool

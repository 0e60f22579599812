#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "ddtool/network/image_settings.hpp"
#include "ddtool/robot/pose2.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"

namespace ddtool {

/// A pixel of a square image: rows from the top, columns from the left.
struct ImagePixel {
    std::size_t row = 0;
    std::size_t column = 0;

    bool operator==(const ImagePixel&) const = default;
};

/// The paper's eqs. (resize) and (index) along one dimension: the swarm's extremes are widened, or narrowed, about
/// their middle to exactly the canvas, and the canvas is cut into pixels of equal size.
class AxisMapping {
public:
    /// Extremes and canvas in metres. The canvas lies about the middle of the extremes.
    AxisMapping(double min_m, double max_m, double canvas_m, std::size_t size_px);

    /// The index of the pixel a coordinate falls in, none where it lies outside of the canvas (or is not finite). A
    /// coordinate between two pixels belongs to the higher one, the canvas's far edge to the last.
    [[nodiscard]] std::optional<std::size_t> pixel(double coordinate_m) const;

private:
    double min_m_;
    double margin_m_;  ///< from the canvas's edge to the lower extreme; negative for a swarm wider than the canvas
    double canvas_m_;
    std::size_t size_px_;
};

/// The x and y that the settings' swarm gives each particle; those with one that is not finite are left out.
void coordinates(std::span<const SnapshotParticle> particles, const ImageSettings& settings,
                 std::vector<Point2>& points);

/// The side of the canvas on which the settings draw this swarm, metres; predicted spreads for the response.
double canvas_side_m(std::span<const SnapshotParticle> particles, const ImageSettings& settings);

/// The pixels of the points that lie on the canvas: x runs to the right, y upwards. Without linear mapping the canvas
/// is one metre a pixel about the origin, so that a coordinate is its pixel's index, counted from the image's middle.
void map_to_pixels(std::span<const Point2> points, double canvas_m, const ImageSettings& settings,
                   std::vector<ImagePixel>& places);

}  // namespace ddtool

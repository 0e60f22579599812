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

/// The paper's eqs. (resize) and (index) along one dimension: the range between the swarm's extremes is widened or
/// narrowed about its middle to exactly the canvas, and the canvas is divided into pixels of equal size.
class AxisMapping {
public:
    /// Extremes and canvas are in metres. The canvas is centred on the middle of the extremes.
    AxisMapping(double min_m, double max_m, double canvas_m, std::size_t size_px);

    /// The index of the pixel that contains a coordinate; nothing if the coordinate lies outside of the canvas or is
    /// not finite. A coordinate on the border between two pixels belongs to the higher one, and the far edge of the
    /// canvas to the last.
    [[nodiscard]] std::optional<std::size_t> pixel(double coordinate_m) const;

private:
    double min_m_;
    double margin_m_;  ///< from the canvas's edge to the lower extreme; negative for a swarm wider than the canvas
    double canvas_m_;
    std::size_t size_px_;
};

/// Fills `points` with the x and y of each particle in the swarm that the settings choose, in metres, or in predicted
/// standard deviations for the response. Particles with a value that is not finite are left out.
void coordinates(std::span<const SnapshotParticle> particles, const ImageSettings& settings,
                 std::vector<Point2>& points);

/// The side of the canvas on which the settings draw this swarm, in metres, or in predicted standard deviations for the
/// response.
double canvas_side_m(std::span<const SnapshotParticle> particles, const ImageSettings& settings);

/// Fills `places` with the pixels of the points that lie on the canvas: x runs to the right, y upwards. Without linear
/// mapping, a pixel is one metre wide and the canvas is centred on the origin, so that a coordinate is the index of its
/// pixel, counted from the middle of the image.
void map_to_pixels(std::span<const Point2> points, double canvas_m, const ImageSettings& settings,
                   std::vector<ImagePixel>& places);

}  // namespace ddtool

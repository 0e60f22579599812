#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "report/colour.hpp"

namespace ddtool::plot {

/// A place on a canvas: pixels from the left and from the top.
struct Pixel {
    double x_px = 0.0;
    double y_px = 0.0;
};

struct Box {
    double left_px = 0.0;
    double top_px = 0.0;
    double width_px = 0.0;
    double height_px = 0.0;
};

/// Which point of a text lies on its anchor.
enum class Anchor { left, centre, right };

/// A white page to draw on, anti-aliased. Drawn twice as large and reduced at the end: OpenCV's stroke fonts read well
/// only so. Texts are ASCII.
class Canvas {
public:
    Canvas(double width_px, double height_px);

    /// The part of this canvas in a box: what is drawn there is seen here, and nothing of it outside of the box.
    [[nodiscard]] Canvas window(const Box& box) const;

    void line(const Pixel& from, const Pixel& to, Colour colour, double width_px);
    /// Points that are not finite leave a gap.
    void path(const std::vector<Pixel>& points, Colour colour, double width_px);
    void disc(const Pixel& centre, double radius_px, Colour colour);
    void fill(const Box& box, Colour colour);
    /// Half-transparent area between the points.
    void shade(const std::vector<Pixel>& corners, Colour colour);
    /// Grey or BGR picture, stretched over the box.
    void picture(const cv::Mat& picture, const Box& box);
    /// height_px: of a capital letter. The anchor is at its middle height.
    void text(const Pixel& at, const std::string& words, double height_px, Anchor anchor = Anchor::centre,
              Colour colour = black);
    /// The same, reading upwards.
    void upright_text(const Pixel& at, const std::string& words, double height_px);
    [[nodiscard]] static double text_width_px(const std::string& words, double height_px);

    /// The page in its own size, BGR.
    [[nodiscard]] cv::Mat3b page() const;

private:
    explicit Canvas(cv::Mat3b pixels) : pixels_(std::move(pixels)) {}

    cv::Mat3b pixels_;
};

}  // namespace ddtool::plot

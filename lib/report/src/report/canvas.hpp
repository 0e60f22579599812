#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "report/colour.hpp"

namespace ddtool::report {

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

/// Which end of a text is placed at the given point.
enum class Anchor { left, centre, right };

/// A white page to draw on, anti-aliased. It is drawn twice as large and reduced at the end, because only then are
/// OpenCV's stroke fonts easy to read. Texts must be ASCII.
class Canvas {
public:
    Canvas(double width_px, double height_px);

    /// The part of this canvas in a box. It shares its pixels with this canvas, and nothing that is drawn in it appears
    /// outside of the box.
    [[nodiscard]] Canvas window(const Box& box) const;

    void line(const Pixel& from, const Pixel& to, Colour colour, double width_px);
    /// A line through the points. A point that is not finite leaves a gap.
    void path(const std::vector<Pixel>& points, Colour colour, double width_px);
    void disc(const Pixel& centre, double radius_px, Colour colour);
    void fill(const Box& box, Colour colour);
    /// A half-transparent area with these corners.
    void shade(const std::vector<Pixel>& corners, Colour colour);
    /// Grey or BGR picture, stretched over the box.
    void picture(const cv::Mat& picture, const Box& box);
    /// \param at the point at half the height of the text, at the end that `anchor` names
    /// \param height_px the height of a capital letter
    void text(const Pixel& at, const std::string& words, double height_px, Anchor anchor = Anchor::centre,
              Colour colour = black);
    /// The same for a text that is turned to be read from bottom to top.
    void upright_text(const Pixel& at, const std::string& words, double height_px);
    [[nodiscard]] static double text_width_px(const std::string& words, double height_px);

    /// The page in its final size, BGR.
    [[nodiscard]] cv::Mat3b page() const;

private:
    explicit Canvas(cv::Mat3b pixels) : pixels_(std::move(pixels)) {}

    cv::Mat3b pixels_;
};

}  // namespace ddtool::report

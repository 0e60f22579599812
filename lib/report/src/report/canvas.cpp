#include "report/canvas.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace ddtool::report {
namespace {

constexpr int enlarged = 2;       ///< the canvas is drawn this many times as large as the page, and then reduced
constexpr int subpixel_bits = 4;  ///< number of fraction bits in the fixed-point coordinates that OpenCV takes
/// coordinates are limited to this, so that points far outside of the page still fit into OpenCV's integers
constexpr double far_px = 1e6;
constexpr int font = cv::FONT_HERSHEY_SIMPLEX;
constexpr double font_height_px = 21.0;  ///< height of a capital letter at OpenCV's font scale 1

cv::Scalar bgr(Colour colour) { return {double(colour.blue), double(colour.green), double(colour.red)}; }

double within_integers(double px) { return std::clamp(px, -far_px, far_px); }

int whole(double px) { return static_cast<int>(std::lround(within_integers(px) * enlarged)); }

cv::Point fixed_point(const Pixel& at) {
    const auto convert = [](double px) {
        return static_cast<int>(std::lround(within_integers(px) * enlarged * (1 << subpixel_bits)));
    };
    return {convert(at.x_px), convert(at.y_px)};
}

cv::Rect rectangle(const Box& box) {
    return {cv::Point(whole(box.left_px), whole(box.top_px)),
            cv::Point(whole(box.left_px + box.width_px), whole(box.top_px + box.height_px))};
}

std::vector<cv::Point> fixed_points(const std::vector<Pixel>& points) {
    std::vector<cv::Point> result;
    std::transform(points.begin(), points.end(), std::back_inserter(result), fixed_point);
    return result;
}

bool is_finite(const Pixel& at) { return std::isfinite(at.x_px) && std::isfinite(at.y_px); }

int thickness(double width_px) { return std::max(1, whole(width_px)); }

double font_scale(double height_px) { return height_px * enlarged / font_height_px; }

int font_thickness(double height_px) { return std::max(1, whole(height_px / 11.0)); }

}  // namespace

Canvas::Canvas(double width_px, double height_px) : pixels_(whole(height_px), whole(width_px), {255, 255, 255}) {}

Canvas Canvas::window(const Box& box) const {
    return Canvas(pixels_(rectangle(box) & cv::Rect(0, 0, pixels_.cols, pixels_.rows)));
}

void Canvas::line(const Pixel& from, const Pixel& to, Colour colour, double width_px) {
    cv::line(pixels_, fixed_point(from), fixed_point(to), bgr(colour), thickness(width_px), cv::LINE_AA, subpixel_bits);
}

void Canvas::path(const std::vector<Pixel>& points, Colour colour, double width_px) {
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (is_finite(points[i - 1]) && is_finite(points[i])) {
            line(points[i - 1], points[i], colour, width_px);
        }
    }
}

void Canvas::disc(const Pixel& centre, double radius_px, Colour colour) {
    if (is_finite(centre)) {
        const int radius = whole(radius_px * (1 << subpixel_bits));
        cv::circle(pixels_, fixed_point(centre), radius, bgr(colour), cv::FILLED, cv::LINE_AA, subpixel_bits);
    }
}

void Canvas::fill(const Box& box, Colour colour) { cv::rectangle(pixels_, rectangle(box), bgr(colour), cv::FILLED); }

void Canvas::shade(const std::vector<Pixel>& corners, Colour colour) {
    cv::Mat3b shaded = pixels_.clone();
    const std::vector<std::vector<cv::Point>> outline{fixed_points(corners)};
    cv::fillPoly(shaded, outline, bgr(colour), cv::LINE_AA, subpixel_bits);
    cv::addWeighted(shaded, 0.25, pixels_, 0.75, 0.0, pixels_);
}

void Canvas::picture(const cv::Mat& picture, const Box& box) {
    const cv::Rect place = rectangle(box);
    if (place.empty()) {
        return;
    }
    cv::Mat coloured = picture;
    if (picture.channels() == 1) {
        cv::cvtColor(picture, coloured, cv::COLOR_GRAY2BGR);
    }
    if (place.width < picture.cols) {  // Each pixel of the reduced picture is the mean of the pixels that it covers.
        cv::Mat reduced;
        cv::resize(coloured, reduced, {place.width, std::max(1, place.height)}, 0, 0, cv::INTER_AREA);
        coloured = reduced;
    }
    const double x_scale = static_cast<double>(place.width) / coloured.cols;
    const double y_scale = static_cast<double>(place.height) / coloured.rows;
    // The shift by half a pixel makes the centres of the pixels coincide. warpAffine() computes the visible part only.
    const cv::Matx23d stretch(x_scale, 0.0, place.x + 0.5 * x_scale - 0.5,  //
                              0.0, y_scale, place.y + 0.5 * y_scale - 0.5);
    cv::warpAffine(coloured, pixels_, stretch, pixels_.size(), cv::INTER_NEAREST, cv::BORDER_TRANSPARENT);
}

void Canvas::text(const Pixel& at, const std::string& words, double height_px, Anchor anchor, Colour colour) {
    const double width_px = text_width_px(words, height_px);
    const double share = anchor == Anchor::left ? 0.0 : anchor == Anchor::centre ? 0.5 : 1.0;
    const cv::Point origin(whole(at.x_px - share * width_px), whole(at.y_px + height_px / 2.0));
    cv::putText(pixels_, words, origin, font, font_scale(height_px), bgr(colour), font_thickness(height_px),
                cv::LINE_AA);
}

void Canvas::upright_text(const Pixel& at, const std::string& words, double height_px) {
    const double width_px = text_width_px(words, height_px) + 2.0;
    Canvas flat(width_px, 2.0 * height_px);
    flat.text({width_px / 2.0, height_px}, words, height_px);
    cv::Mat turned;
    cv::rotate(flat.pixels_, turned, cv::ROTATE_90_COUNTERCLOCKWISE);
    picture(turned, {at.x_px - height_px, at.y_px - width_px / 2.0, 2.0 * height_px, width_px});
}

double Canvas::text_width_px(const std::string& words, double height_px) {
    int below_line = 0;
    const cv::Size size = cv::getTextSize(words, font, font_scale(height_px), font_thickness(height_px), &below_line);
    return static_cast<double>(size.width) / enlarged;
}

cv::Mat3b Canvas::page() const {
    cv::Mat3b reduced;
    cv::resize(pixels_, reduced, pixels_.size() / enlarged, 0, 0, cv::INTER_AREA);
    return reduced;
}

}  // namespace ddtool::report

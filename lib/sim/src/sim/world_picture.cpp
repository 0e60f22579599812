#include "sim/world_picture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "system/png_file.hpp"

namespace ddtool::sim {
namespace {

constexpr double longer_side_px = 1600.0;
constexpr double most_px_per_m = 60.0;
constexpr double margin_m = 1.0;
/// OpenCV gets pixel coordinates as fixed-point numbers with this many binary digits after the point, so that slanted
/// lines stay straight.
constexpr int fraction_bits = 4;

const cv::Scalar white(255, 255, 255);
const cv::Scalar black(0, 0, 0);
const cv::Scalar blue(220, 120, 30);
const cv::Scalar red(40, 40, 220);
const cv::Scalar green(60, 160, 30);

class Picture {
public:
    Picture(const World& world, const Trajectory& driven) {
        for (const Segment& segment : world.segments) {
            include(segment.a, margin_m);
            include(segment.b, margin_m);
        }
        for (const Arc& arc : world.arcs) {
            include(arc.centre, arc.radius_m + margin_m);
        }
        for (const StampedPose& stamped : driven) {
            include({stamped.pose.x_m, stamped.pose.y_m}, margin_m);
        }
        const double longer_m = std::max(high_.x_m - low_.x_m, high_.y_m - low_.y_m);
        px_per_m_ = std::min(most_px_per_m, longer_side_px / longer_m);
        const auto size_px = [&](double metres) { return static_cast<int>(std::ceil(metres * px_per_m_)); };
        image_ = cv::Mat(size_px(high_.y_m - low_.y_m), size_px(high_.x_m - low_.x_m), CV_8UC3, white);
    }

    void line(const Point2& a, const Point2& b, const cv::Scalar& colour) {
        cv::line(image_, at(a), at(b), colour, 1, cv::LINE_AA, fraction_bits);
    }
    void circle(const Point2& centre, double radius_m, const cv::Scalar& colour, int thickness) {
        const auto radius = static_cast<int>(std::lround(radius_m * px_per_m_ * (1 << fraction_bits)));
        cv::circle(image_, at(centre), radius, colour, thickness, cv::LINE_AA, fraction_bits);
    }
    void dot(const Point2& centre, const cv::Scalar& colour) { circle(centre, 5.0 / px_per_m_, colour, cv::FILLED); }

    void write(const std::filesystem::path& file) const { write_png(file, pixels_of(image_)); }

private:
    void include(const Point2& point, double margin) {
        low_ = {std::min(low_.x_m, point.x_m - margin), std::min(low_.y_m, point.y_m - margin)};
        high_ = {std::max(high_.x_m, point.x_m + margin), std::max(high_.y_m, point.y_m + margin)};
    }

    [[nodiscard]] cv::Point at(const Point2& point) const {
        const double scale = px_per_m_ * (1 << fraction_bits);
        return {static_cast<int>(std::lround((point.x_m - low_.x_m) * scale)),
                static_cast<int>(std::lround((high_.y_m - point.y_m) * scale))};
    }

    static constexpr double infinity = std::numeric_limits<double>::infinity();
    Point2 low_{infinity, infinity};
    Point2 high_{-infinity, -infinity};
    double px_per_m_ = 1.0;
    cv::Mat image_;
};

void draw(Picture& picture, const Arc& arc) {
    constexpr int steps = 180;
    const auto at = [&](int step) {
        const double angle_rad = arc.start_rad + arc.sweep_rad * step / steps;
        return Point2{arc.centre.x_m + arc.radius_m * std::cos(angle_rad),
                      arc.centre.y_m + arc.radius_m * std::sin(angle_rad)};
    };
    for (int step = 1; step <= steps; ++step) {
        picture.line(at(step - 1), at(step), black);
    }
}

}  // namespace

void write_world_picture(const std::filesystem::path& file, const World& world, const Trajectory& driven) {
    Picture picture(world, driven);
    for (std::size_t i = 1; i < driven.size(); ++i) {
        picture.line({driven[i - 1].pose.x_m, driven[i - 1].pose.y_m}, {driven[i].pose.x_m, driven[i].pose.y_m}, blue);
    }
    for (const Segment& segment : world.segments) {
        picture.line(segment.a, segment.b, black);
    }
    for (const Arc& arc : world.arcs) {
        draw(picture, arc);
    }
    for (const Point2& point : world.route.way_points) {
        picture.dot(point, red);
    }
    picture.dot({world.route.start.x_m, world.route.start.y_m}, green);
    picture.write(file);
}

}  // namespace ddtool::sim

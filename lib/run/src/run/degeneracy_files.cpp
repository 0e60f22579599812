#include "run/degeneracy_files.hpp"

#include <array>
#include <cstdio>
#include <ostream>

#include "report/figure.hpp"

namespace ddtool {
namespace {

constexpr const char* header =
    "stamp_ns,degree,dispersion,major_sd_m,minor_sd_m,major_direction_rad,corrected_m,resampled,x_m,y_m,theta_rad,"
    "cov_xx,cov_xy,cov_xt,cov_yy,cov_yt,cov_tt\n";

void write_row(std::ostream& out, const UpdateSummary& update) {
    const auto number = [&](double value) {
        std::array<char, 32> text{};
        std::snprintf(text.data(), text.size(), ",%.9g", value);
        out << text.data();
    };
    out << update.stamp_ns;
    for (const double value : {update.degree, update.dispersion, update.swarm.major_sd_m(), update.swarm.minor_sd_m(),
                               update.swarm.major_direction_rad, update.corrected_m, update.resampled ? 1.0 : 0.0,
                               update.pose.x_m, update.pose.y_m, update.pose.theta_rad}) {
        number(value);
    }
    for (Eigen::Index row = 0; row < 3; ++row) {
        for (Eigen::Index column = row; column < 3; ++column) {
            number(update.covariance(row, column));
        }
    }
    out << '\n';
}

void draw_time_line(report::Axes& axes, const std::vector<UpdateSummary>& updates) {
    std::vector<double> time_s, degree, corrected_m;
    for (const UpdateSummary& update : updates) {
        time_s.push_back(1e-9 * static_cast<double>(update.stamp_ns - updates.front().stamp_ns));
        degree.push_back(update.degree);
        corrected_m.push_back(10.0 * update.corrected_m);
    }
    axes.x_label("time [s]").y_label("degree").y_range(0.0, 1.0);
    axes.line(time_s, degree, {.label = "degree", .colour = report::series_colour(0)});
    axes.line(time_s, corrected_m, {.label = "correction [0.1 m]", .colour = report::series_colour(1)});
}

}  // namespace

DegeneracyCsv::DegeneracyCsv(const std::filesystem::path& file) : file_(file) {
    file_.write([](std::ostream& out) { out << header; });
}

void DegeneracyCsv::add(const UpdateSummary& update) {
    file_.write([&](std::ostream& out) { write_row(out, update); });
}

void write_degeneracy_picture(const std::filesystem::path& file, const std::vector<UpdateSummary>& updates,
                              const MapRaster& map, const Trajectory& path) {
    report::Figure figure({.height_px = 900.0, .row_shares = {3.0, 1.0}});
    const std::vector<std::uint8_t> pixels = map_pixels(map);
    std::vector<double> x_m, y_m, degree;
    for (const auto& [stamp_ns, pose] : places_of(updates, path)) {
        x_m.push_back(pose.x_m);
        y_m.push_back(pose.y_m);
        degree.push_back(updates[degree.size()].degree);
    }
    figure.axes(0)
        .equal_aspect()
        .picture({.width_px = map.width, .height_px = map.height, .channels = 1, .pixels = pixels},
                 {map.origin_m.x_m, map.origin_m.x_m + map.width_m()},
                 {map.origin_m.y_m, map.origin_m.y_m + map.height_m()})
        .heat_line(x_m, y_m, degree, "degree")
        .x_label("x [m]")
        .y_label("y [m]");
    if (!updates.empty()) {
        draw_time_line(figure.axes(1), updates);
    }
    figure.write_png(file);
}

}  // namespace ddtool

#include "run/run_explorer.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "report/data_uri.hpp"
#include "report/map_raster.hpp"
#include "report/thinning.hpp"
#include "scores/absolute_error.hpp"
#include "system/png_file.hpp"

namespace ddtool {
namespace {

constexpr std::size_t most_rows = 4000;
constexpr double length_step_m = 0.001;  ///< lengths and times are rounded to these steps
constexpr double time_step_s = 0.001;

struct Line {
    std::string name;
    std::string unit;
    double step;  ///< values are rounded to a multiple of it
    Json limits;  ///< {"low", "high"}: the limits of its scale; where one is missing, it follows from the values
    std::vector<double> values;
    bool shows_resampling = false;
};

template <typename Value>
std::vector<double> values_of(const RunCourse& course, Value value) {
    std::vector<double> values;
    values.reserve(course.updates().size());
    for (const UpdateSummary& update : course.updates()) {
        values.push_back(value(update));
    }
    return values;
}

/// The true positions at the updates, in the frame of the map, and the distances of the path from them. A distance is
/// NaN where the truth is not known.
struct Truth {
    Trajectory places;
    std::vector<double> errors_m;
};

Truth truth_of(const FilterRun& run, const Trajectory& path) {
    Truth truth;
    if (run.ground_truth.empty()) {
        return truth;
    }
    const Pose2 map_from_truth =
        inverse(absolute_trajectory_error(run.trajectory, run.ground_truth).reference_from_estimate);
    const StampIndex index(run.ground_truth);
    for (const auto& [stamp_ns, pose] : path) {
        const auto known = index.nearest(stamp_ns, default_max_time_difference_s);
        truth.errors_m.push_back(NAN);
        if (known) {
            truth.places.push_back({stamp_ns, map_from_truth * run.ground_truth[*known].pose});
            truth.errors_m.back() = distance_m(truth.places.back().pose, pose);
        }
    }
    return truth;
}

bool says_something(const Line& line) {
    return std::any_of(line.values.begin(), line.values.end(), [](double value) { return std::abs(value) > 0.0; });
}

/// The quantities by which the path can be coloured, the most useful one first. Quantities that are 0 throughout are
/// left out, for example the degree of a method without a detector.
std::vector<Line> lines_of(const RunCourse& course, const Truth& truth) {
    const Json at_least_0{{"low", 0.0}};
    std::vector<Line> lines{
        {"degree",
         "",
         1e-4,
         {{"low", 0.0}, {"high", 1.0}},
         values_of(course, [](const UpdateSummary& update) { return update.degree; })},
        {"spread of the particles", "m", 1e-4, at_least_0,
         values_of(course, [](const UpdateSummary& update) { return update.swarm.major_sd_m(); })},
        {"effective sample size", "", 0.01, at_least_0,
         values_of(course, [](const UpdateSummary& update) { return update.effective_size; }), true},
        {"correction", "m", 1e-4, at_least_0,
         values_of(course, [](const UpdateSummary& update) { return update.corrected_m; })},
        {"distance from the truth", "m", 1e-4, at_least_0, truth.errors_m},
        {"step time", "ms", 1e-3, at_least_0,
         values_of(course, [](const UpdateSummary& update) { return 1e3 * update.step_s; })}};
    std::erase_if(lines, [](const Line& line) { return !says_something(line); });
    return lines;
}

/// The value rounded to a multiple of `step`. Dividing by the inverse of the step gives the double with the shortest
/// text: multiplying 3 by 0.1 would give 0.30000000000000004.
Json number(double value, double step) {
    const double inverse_step = std::round(1.0 / step);
    return std::isfinite(value) ? Json(std::round(value * inverse_step) / inverse_step) : Json();
}

Json places_json(const Trajectory& places, const std::vector<std::size_t>& rows) {
    Json json{{"x_m", Json::array()}, {"y_m", Json::array()}};
    for (const std::size_t row : rows) {
        json["x_m"].push_back(number(places[row].pose.x_m, length_step_m));
        json["y_m"].push_back(number(places[row].pose.y_m, length_step_m));
    }
    return json;
}

Json line_json(const Line& line, const std::vector<std::size_t>& rows) {
    Json json{{"name", line.name}, {"unit", line.unit}, {"values", Json::array()}};
    json.update(line.limits);
    for (const std::size_t row : rows) {
        json["values"].push_back(number(line.values[row], line.step));
    }
    return json;
}

/// The numbers of the rows at which a resampling is shown: the swarm was resampled at that row's update, or at one of
/// the updates between the previous row and that row.
Json resampled_rows(const RunCourse& course, const std::vector<std::size_t>& rows) {
    Json resampled = Json::array();
    std::size_t update = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        bool any = false;
        for (; update <= rows[row]; ++update) {
            any = any || course.updates()[update].resampled;
        }
        if (any) {
            resampled.push_back(row);
        }
    }
    return resampled;
}

/// The times of the rows in seconds since the first scan.
Json times_json(const RunCourse& course, const FilterRun& run, const std::vector<std::size_t>& rows) {
    Json times{{"name", "time"}, {"unit", "s"}, {"values", Json::array()}};
    for (const std::size_t row : rows) {
        const std::int64_t elapsed_ns = course.updates()[row].stamp_ns - run.trajectory.front().stamp_ns;
        times["values"].push_back(number(1e-9 * static_cast<double>(elapsed_ns), time_step_s));
    }
    return times;
}

Json map_json(const MapRaster& map) {
    const std::vector<std::uint8_t> pixels = map_pixels(map);
    const std::string png =
        png_bytes({.width_px = map.width, .height_px = map.height, .channels = 1, .pixels = pixels});
    return {{"image", report::png_uri(png)},
            {"left_m", map.origin_m.x_m},
            {"bottom_m", map.origin_m.y_m},
            {"width_m", map.width_m()},
            {"height_m", map.height_m()}};
}

std::vector<std::size_t> rows_of(const std::vector<Line>& lines) {
    std::vector<std::vector<double>> values;
    values.reserve(lines.size());
    for (const Line& line : lines) {
        values.push_back(line.values);
    }
    return report::telling_rows(values, most_rows);
}

std::vector<std::size_t> rows_of(const Trajectory& places) {
    std::vector<std::vector<double>> values(2);
    for (const auto& [stamp_ns, pose] : places) {
        values[0].push_back(pose.x_m);
        values[1].push_back(pose.y_m);
    }
    return report::telling_rows(values, most_rows);
}

}  // namespace

RunExplorer run_explorer(const FilterRun& run, const MapRaster& map, const RunCourse& course) {
    const Trajectory path = places_of(course.updates(), run.trajectory);
    const Truth truth = truth_of(run, path);
    const std::vector<Line> lines = lines_of(course, truth);
    RunExplorer explorer{rows_of(lines), Json::object()};
    Json& data = explorer.data;
    data["map"] = map_json(map);
    data["x"] = times_json(course, run, explorer.updates);
    data["place"] = places_json(path, explorer.updates);
    data["lines"] = Json::array();
    for (const Line& line : lines) {
        data["lines"].push_back(line_json(line, explorer.updates));
        if (line.shows_resampling) {
            data["lines"].back()["events"] = resampled_rows(course, explorer.updates);
        }
    }
    if (!truth.places.empty()) {
        data["reference"] = places_json(truth.places, rows_of(truth.places));
        data["reference"]["name"] = "ground truth";
    }
    return explorer;
}

}  // namespace ddtool

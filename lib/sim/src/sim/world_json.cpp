#include "sim/world_json.hpp"

#include <cmath>
#include <vector>

#include "ddtool/base/error.hpp"

namespace ddtool::sim {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
constexpr double most_way_points = 1e6;  ///< of all laps

Json known_world() {
    return {{"name", ""},
            {"description", ""},
            {"start", Json::array({0.0, 0.0, 0.0})},
            {"way_points", Json::array()},
            {"laps", 1.0},
            {"walls", Json::array()},
            {"boxes", Json::array()},
            {"circles", Json::array()},
            {"arcs", Json::array()}};
}

Json known_box() { return {{"centre", {0.0, 0.0}}, {"size", {1.0, 1.0}}, {"heading_deg", 0.0}}; }

Json known_circle() { return {{"centre", {0.0, 0.0}}, {"radius_m", 1.0}}; }

Json known_arc() { return {{"centre", {0.0, 0.0}}, {"radius_m", 1.0}, {"from_deg", 0.0}, {"to_deg", 360.0}}; }

std::string place(const std::string& source, const std::string& key, std::size_t index) {
    return source + ": " + key + "[" + std::to_string(index) + "]";
}

std::vector<double> numbers(const Json& json, std::size_t count, const std::string& where) {
    bool good = json.is_array() && json.size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
        good = json[i].is_number() && std::isfinite(json[i].get<double>());
    }
    if (!good) {
        throw UsageError(where + " is " + json.dump() + ", expected " + std::to_string(count) + " numbers");
    }
    return json.get<std::vector<double>>();
}

Point2 point(const Json& json, const std::string& where) {
    const std::vector<double> values = numbers(json, 2, where);
    return {values[0], values[1]};
}

std::vector<Point2> points(const Json& json, const std::string& where) {
    if (!json.is_array()) {
        throw UsageError(where + " is " + json.dump() + ", expected a list of points [x, y]");
    }
    std::vector<Point2> result;
    for (const Json& item : json) {
        result.push_back(point(item, where));
    }
    return result;
}

double positive(const Json& json, const std::string& where) {
    if (!(json.get<double>() > 0.0)) {
        throw UsageError(where + " is " + json.dump() + ", expected a number above 0");
    }
    return json.get<double>();
}

/// Returns the item, with the defaults in `known` for the keys that it leaves out.
Json completed(Json known, const Json& item, const std::string& where) {
    merge_settings(known, item, where);
    return known;
}

void add_boxes(World& world, const Json& boxes, const std::string& source) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const std::string where = place(source, "boxes", i);
        const Json box = completed(known_box(), boxes[i], where);
        const Point2 centre = point(box["centre"], where + ".centre");
        const std::vector<double> size = numbers(box["size"], 2, where + ".size");
        add_box(world, {centre.x_m, centre.y_m, box["heading_deg"].get<double>() * rad_per_deg}, size[0], size[1]);
    }
}

void add_arcs(World& world, const Json& arcs, const Json& known, const std::string& key, const std::string& source) {
    for (std::size_t i = 0; i < arcs.size(); ++i) {
        const std::string where = place(source, key, i);
        const Json arc = completed(known, arcs[i], where);
        const double from_deg = arc.value("from_deg", 0.0);
        const double to_deg = arc.value("to_deg", 360.0);
        if (!(to_deg > from_deg && to_deg - from_deg <= 360.0)) {
            throw UsageError(where + ": expected from_deg below to_deg, and at most 360 between them");
        }
        world.arcs.push_back({point(arc["centre"], where + ".centre"), positive(arc["radius_m"], where + ".radius_m"),
                              from_deg * rad_per_deg, (to_deg - from_deg) * rad_per_deg});
    }
}

Route route_from(const Json& world, const std::string& source) {
    const std::vector<double> start = numbers(world["start"], 3, source + ": start");
    Route route{.start = {start[0], start[1], start[2] * rad_per_deg},
                .way_points = points(world["way_points"], source + ": way_points"),
                .laps = positive(world["laps"], source + ": laps")};
    if (route.laps * static_cast<double>(route.way_points.size()) > most_way_points) {
        throw UsageError(source + ": laps is " + world["laps"].dump() + ", expected at most 1000000 way points in all");
    }
    if (all_way_points(route).empty()) {
        throw UsageError(source + ": way_points: expected at least one point [x, y] to drive to");
    }
    return route;
}

}  // namespace

World world_from_json(const Json& json, const std::string& source) {
    const Json known = completed(known_world(), json, source);
    World world{.name = known["name"].get<std::string>(),
                .description = known["description"].get<std::string>(),
                .segments = {},
                .arcs = {},
                .route = route_from(known, source)};
    for (std::size_t i = 0; i < known["walls"].size(); ++i) {
        add_polyline(world, points(known["walls"][i], place(source, "walls", i)));
    }
    add_boxes(world, known["boxes"], source);
    add_arcs(world, known["circles"], known_circle(), "circles", source);
    add_arcs(world, known["arcs"], known_arc(), "arcs", source);
    return world;
}

}  // namespace ddtool::sim

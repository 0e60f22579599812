#include "sim/world_fingerprint.hpp"

#include "system/fingerprint.hpp"

namespace ddtool::sim {

std::string world_fingerprint(const World& world) {
    Fingerprint fingerprint;
    const auto add_point = [&](const Point2& point) { fingerprint.add(point.x_m).add(point.y_m); };
    for (const Segment& segment : world.segments) {
        add_point(segment.a);
        add_point(segment.b);
    }
    fingerprint.add("arcs");
    for (const Arc& arc : world.arcs) {
        add_point(arc.centre);
        fingerprint.add(arc.radius_m).add(arc.start_rad).add(arc.sweep_rad);
    }
    fingerprint.add("route");
    add_point({world.route.start.x_m, world.route.start.y_m});
    fingerprint.add(world.route.start.theta_rad).add(world.route.laps);
    for (const Point2& point : world.route.way_points) {
        add_point(point);
    }
    return fingerprint.hex();
}

}  // namespace ddtool::sim

#include "bench_worlds.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "ddtool/base/error.hpp"
#include "ddtool/base/random.hpp"

namespace ddtool::matcher_bench {
namespace {

/// So far the corridors go on beyond the ends of the route: more than the 30 m that the longest lidar of the bench
/// sees.
constexpr double beyond_m = 35.0;
constexpr std::uint64_t world_draw = 101;

/// A wall along the x axis of the frame of a corridor, drawn from left to right. `out` is the distance behind the wall
/// as seen from the corridor.
class WallLine {
public:
    /// \param y_m where the wall stands; the corridor is on the side of y = 0
    WallLine(sim::World& world, const Pose2& world_from_corridor, double x_m, double y_m)
        : world_(world),
          world_from_corridor_(world_from_corridor),
          wall_y_m_(y_m),
          side_(y_m < 0.0 ? -1.0 : 1.0),
          last_{x_m, y_m} {}

    [[nodiscard]] double x_m() const { return last_.x_m; }

    void line_to(double x_m, double out_m) {
        const Point2 next{x_m, wall_y_m_ + side_ * out_m};
        world_.segments.push_back({world_from_corridor_ * last_, world_from_corridor_ * next});
        last_ = next;
    }

    /// Half a circle from the wall back to the wall, behind it (a bay) or before it (half a column).
    void half_circle(double radius_m, bool behind) {
        const double turned_rad = (side_ > 0.0) == behind ? 0.0 : std::numbers::pi;
        world_.arcs.push_back({.centre = world_from_corridor_ * Point2{last_.x_m + radius_m, wall_y_m_},
                               .radius_m = radius_m,
                               .start_rad = wrap_angle(world_from_corridor_.theta_rad + turned_rad),
                               .sweep_rad = std::numbers::pi});
        last_.x_m += 2.0 * radius_m;
    }

private:
    sim::World& world_;
    Pose2 world_from_corridor_;
    double wall_y_m_;
    double side_;
    Point2 last_;
};

/// Draws one feature of a wall at the end of the line.
using AddFeature = std::function<void(WallLine& wall, RandomStream& random)>;

struct Spacing {
    double least_m;
    double most_m;
};

void add_recess(WallLine& wall, double width_m, double depth_m) {
    const double begin_m = wall.x_m();
    wall.line_to(begin_m, depth_m);
    wall.line_to(begin_m + width_m, depth_m);
    wall.line_to(begin_m + width_m, 0.0);
}

/// Two walls with features, and a route between them.
void add_corridor(sim::World& world, const Pose2& world_from_corridor, double half_width_m, double length_m,
                  const Spacing& spacing, const AddFeature& add_feature, RandomStream& random) {
    const double end_m = length_m + beyond_m;
    for (const double side : {1.0, -1.0}) {
        WallLine wall(world, world_from_corridor, -beyond_m, side * half_width_m);
        while (add_feature) {
            const double next_m = wall.x_m() + random.uniform(spacing.least_m, spacing.most_m);
            if (next_m >= end_m) {
                break;
            }
            wall.line_to(next_m, 0.0);
            add_feature(wall, random);
        }
        wall.line_to(std::max(end_m, wall.x_m() + 1.0), 0.0);
    }
}

/// The robot does not drive along a corridor as on a rail: it turns a little at points some metres apart.
void add_wandering_route(sim::World& world, const Pose2& world_from_corridor, double length_m, RandomStream& random) {
    constexpr double wander_m = 0.15;
    constexpr double leg_m = 8.0;
    world.route.start = world_from_corridor;
    for (double x_m = leg_m; x_m < length_m - 0.5 * leg_m; x_m += leg_m) {
        world.route.way_points.push_back(world_from_corridor * Point2{x_m, random.uniform(-wander_m, wander_m)});
    }
    world.route.way_points.push_back(world_from_corridor * Point2{length_m, 0.0});
}

/// Where a world lies in the map.
struct Site {
    Pose2 world_from_site;
    double length_m;
};

void add_featured_corridor(sim::World& world, const Site& site, const Spacing& spacing, const AddFeature& add_feature,
                           RandomStream& random) {
    add_corridor(world, site.world_from_site, random.uniform(0.9, 1.4), site.length_m, spacing, add_feature, random);
    add_wandering_route(world, site.world_from_site, site.length_m, random);
}

void draw_recesses(sim::World& world, const Site& site, RandomStream& random) {
    add_featured_corridor(
        world, site, {2.0, 10.0},
        [](WallLine& wall, RandomStream& draw) { add_recess(wall, draw.uniform(0.8, 1.2), draw.uniform(0.1, 0.5)); },
        random);
}

/// Few and shallow recesses: what holds the robot along such a corridor is a small part of each scan.
void draw_doors(sim::World& world, const Site& site, RandomStream& random) {
    add_featured_corridor(
        world, site, {2.0, 8.0},
        [](WallLine& wall, RandomStream& draw) { add_recess(wall, draw.uniform(0.85, 1.1), draw.uniform(0.08, 0.2)); },
        random);
}

void draw_corners(sim::World& world, const Site& site, RandomStream& random) {
    add_featured_corridor(
        world, site, {4.0, 12.0},
        [](WallLine& wall, RandomStream& draw) { add_recess(wall, draw.uniform(1.2, 2.4), draw.uniform(2.0, 5.0)); },
        random);
}

void draw_oblique(sim::World& world, const Site& site, RandomStream& random) {
    add_featured_corridor(
        world, site, {2.0, 8.0},
        [](WallLine& wall, RandomStream& draw) {
            const double begin_m = wall.x_m();
            const double depth_m = draw.uniform(0.2, 0.6);
            const double rise_m = depth_m / std::tan(draw.uniform(0.3, 1.1));
            const double fall_m = depth_m / std::tan(draw.uniform(0.3, 1.1));
            const double flat_m = draw.uniform(0.3, 1.0);
            wall.line_to(begin_m + rise_m, depth_m);
            wall.line_to(begin_m + rise_m + flat_m, depth_m);
            wall.line_to(begin_m + rise_m + flat_m + fall_m, 0.0);
        },
        random);
}

void draw_curved(sim::World& world, const Site& site, RandomStream& random) {
    add_featured_corridor(
        world, site, {2.0, 8.0},
        [](WallLine& wall, RandomStream& draw) {
            const bool bay = draw.uniform() < 0.5;
            wall.half_circle(bay ? draw.uniform(0.4, 1.2) : draw.uniform(0.15, 0.35), bay);
        },
        random);
}

void draw_bare(sim::World& world, const Site& site, RandomStream& random) {
    add_featured_corridor(world, site, {}, nullptr, random);
}

/// A hall with two rows of pillars; the robot drives between the rows.
void draw_pillars(sim::World& world, const Site& site, RandomStream& random) {
    const Pose2& place = site.world_from_site;
    add_corridor(world, place, random.uniform(3.0, 4.0), site.length_m, {}, nullptr, random);
    for (const double side : {1.0, -1.0}) {
        for (double x_m = -beyond_m; x_m < site.length_m + beyond_m; x_m += random.uniform(3.0, 7.0)) {
            const Point2 centre = place * Point2{x_m, side * random.uniform(1.2, 2.0)};
            const double size_m = random.uniform(0.2, 0.5);
            if (random.uniform() < 0.5) {
                world.arcs.push_back({.centre = centre, .radius_m = 0.5 * size_m});
            } else {
                add_box(world, {centre.x_m, centre.y_m, place.theta_rad}, size_m, size_m);
            }
        }
    }
    add_wandering_route(world, place, site.length_m, random);
}

/// A room with furniture, and one lap about it.
void draw_room(sim::World& world, const Site& site, RandomStream& random) {
    const Pose2& place = site.world_from_site;
    const double length_m = random.uniform(8.0, 14.0);
    const double width_m = random.uniform(6.0, 10.0);
    add_box(world, place, length_m, width_m);
    add_box(world, place * Pose2{0.0, 0.0, random.uniform(-0.5, 0.5)}, 0.15 * length_m, 0.1 * width_m);
    for (const double x_side : {1.0, -1.0}) {
        for (const double y_side : {1.0, -1.0}) {
            const Pose2 corner{0.5 * x_side * length_m, 0.5 * y_side * width_m, 0.0};
            const double deep_m = random.uniform(0.3, 0.8);
            add_box(world, place * corner * Pose2{-x_side * 0.5 * deep_m, -y_side * 0.6, 0.0}, deep_m, 1.0);
        }
    }
    const double x_m = 0.5 * length_m - 1.8;
    const double y_m = 0.5 * width_m - 1.8;
    world.route.start = place * Pose2{-x_m, -y_m, 0.0};
    for (const Point2& corner : {Point2{x_m, -y_m}, Point2{x_m, y_m}, Point2{-x_m, y_m}, Point2{-x_m, -y_m}}) {
        world.route.way_points.push_back(place * corner);
    }
}

struct Maker {
    WorldKind kind;
    void (*draw)(sim::World& world, const Site& site, RandomStream& random);
    bool is_corridor = true;
};

const std::vector<Maker>& makers() {
    static const std::vector<Maker> table{
        {{"recesses", "corridor with door recesses 0.1 to 0.5 m deep, 2 to 10 m apart"}, draw_recesses},
        {{"doors", "corridor with doors that stand 8 to 20 cm back, 2 to 8 m apart"}, draw_doors},
        {{"corners", "corridor with side rooms 2 to 5 m deep, 4 to 12 m apart"}, draw_corners},
        {{"pillars", "hall with two rows of round and square pillars"}, draw_pillars},
        {{"oblique", "corridor with niches that have slanting sides"}, draw_oblique},
        {{"curved", "corridor with round bays and half columns"}, draw_curved},
        {{"room", "room with furniture, driven about once"}, draw_room, false},
        {{"bare", "corridor with plain walls, which hold nothing along"}, draw_bare},
    };
    return table;
}

}  // namespace

const std::vector<WorldKind>& world_kinds() {
    static const std::vector<WorldKind> kinds = [] {
        std::vector<WorldKind> all;
        for (const Maker& maker : makers()) {
            all.push_back(maker.kind);
        }
        return all;
    }();
    return kinds;
}

BenchWorld draw_world(const std::string& kind, std::uint64_t layout, double length_m) {
    const auto found =
        std::find_if(makers().begin(), makers().end(), [&](const Maker& maker) { return maker.kind.name == kind; });
    if (found == makers().end()) {
        std::string names;
        for (const Maker& maker : makers()) {
            names += (names.empty() ? "" : ", ") + maker.kind.name;
        }
        throw UsageError("unknown world '" + kind + "'; expected one of " + names);
    }
    RandomStream random({layout, world_draw, static_cast<std::uint64_t>(found - makers().begin())});
    // The place in its cell differs between the layouts, too.
    Site site{{random.uniform(0.0, 0.1), random.uniform(0.0, 0.1), 0.0}, length_m};
    if (layout % 2 == 0) {
        site.world_from_site.theta_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
    }
    BenchWorld result;
    result.world.name = kind + "-" + std::to_string(layout);
    result.world.description = found->kind.description;
    found->draw(result.world, site, random);
    if (found->is_corridor) {
        result.along_rad = site.world_from_site.theta_rad;
    }
    return result;
}

}  // namespace ddtool::matcher_bench

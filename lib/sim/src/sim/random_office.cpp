#include <algorithm>
#include <cmath>

#include "ddtool/base/random.hpp"
#include "sim/random_purpose.hpp"
#include "sim/random_worlds.hpp"

namespace ddtool::sim {
namespace {

constexpr double door_width_m = 1.0;

/// A room on one side of the corridor. The corridor runs along x, and its middle is at y = 0.
struct Room {
    double left_m;
    double right_m;
    double corridor_wall_m;  ///< y; the sign tells the side of the corridor
    double back_wall_m;      ///< y
    double door_m;           ///< x of the door's middle

    [[nodiscard]] Point2 centre() const { return {door_m, (corridor_wall_m + back_wall_m) / 2.0}; }
};

std::vector<Room> draw_rooms(double length_m, double corridor_wall_m, RandomStream& random) {
    std::vector<Room> rooms;
    const double depth_m = std::copysign(random.uniform(4.0, 7.0), corridor_wall_m);
    double left_m = 0.0;
    while (left_m < length_m) {
        double right_m = left_m + random.uniform(3.0, 7.0);
        right_m = length_m - right_m < 3.0 ? length_m : right_m;
        const double door_m = random.uniform(left_m + 1.0, right_m - 1.0);
        rooms.push_back({left_m, right_m, corridor_wall_m, corridor_wall_m + depth_m, door_m});
        left_m = right_m;
    }
    return rooms;
}

/// Adds the walls of a room except the right one, which is the left wall of the next room or the end of the row.
void add_walls(World& world, const Room& room) {
    const double near = room.corridor_wall_m;
    const double far = room.back_wall_m;
    add_polyline(world, {{room.left_m, near}, {room.door_m - door_width_m / 2.0, near}});
    add_polyline(world, {{room.door_m + door_width_m / 2.0, near}, {room.right_m, near}});
    add_polyline(world, {{room.left_m, near}, {room.left_m, far}, {room.right_m, far}});
}

void close_row(World& world, const Room& last) {
    add_polyline(world, {{last.right_m, last.corridor_wall_m}, {last.right_m, last.back_wall_m}});
}

/// Adds a box at the back wall, and boxes in those corners at the corridor that are away from the line through the
/// door, along which the robot drives.
void furnish(World& world, const Room& room, RandomStream& random) {
    const double side = std::copysign(1.0, room.back_wall_m - room.corridor_wall_m);
    const double into_room_m = random.uniform(0.4, 0.8);
    const double along_wall_m = random.uniform(0.8, std::min(2.5, room.right_m - room.left_m - 0.4));
    const double x = random.uniform(room.left_m + along_wall_m / 2.0, room.right_m - along_wall_m / 2.0);
    add_box(world, {x, room.back_wall_m - side * into_room_m / 2.0, 0.0}, along_wall_m, into_room_m);
    for (const double corner_m : {room.left_m + 0.3, room.right_m - 0.3}) {
        if (std::abs(corner_m - room.door_m) > 1.2) {
            add_box(world, {corner_m, room.corridor_wall_m + side * random.uniform(0.6, 1.5), 0.0}, 0.5,
                    random.uniform(0.5, 1.0));
        }
    }
}

void visit(Route& route, const Room& room) {
    route.way_points.push_back({room.door_m, 0.0});
    route.way_points.push_back(room.centre());
    route.way_points.push_back({room.door_m, 0.0});
}

}  // namespace

World random_office(std::uint64_t seed) {
    RandomStream random({seed, random_layout, 1});
    const double length_m = random.uniform(18.0, 50.0);
    const double half_width_m = random.uniform(0.8, 1.4);
    World world{.name = "random:office:" + std::to_string(seed),
                .description = "corridor with rooms, drawn by seed",
                .segments = {},
                .arcs = {},
                .route = {.start = {1.0, 0.0, 0.0}, .way_points = {}}};
    std::vector<Room> rooms = draw_rooms(length_m, half_width_m, random);
    const std::vector<Room> below = draw_rooms(length_m, -half_width_m, random);
    close_row(world, rooms.back());
    close_row(world, below.back());
    rooms.insert(rooms.end(), below.begin(), below.end());
    std::sort(rooms.begin(), rooms.end(), [](const Room& a, const Room& b) { return a.door_m < b.door_m; });
    for (const Room& room : rooms) {
        add_walls(world, room);
        furnish(world, room, random);
        if (random.uniform() < 0.35) {
            visit(world.route, room);
        }
    }
    for (const double end_m : {0.0, length_m}) {
        add_polyline(world, {{end_m, -half_width_m}, {end_m, half_width_m}});
    }
    world.route.way_points.push_back({length_m - 1.0, 0.0});
    world.route.way_points.push_back({1.0, 0.0});
    return world;
}

}  // namespace ddtool::sim

#include <cmath>
#include <filesystem>
#include <iostream>
#include <memory>

#include "base/text.hpp"
#include "commands.hpp"
#include "graph/g2o_file.hpp"
#include "maps/any_map.hpp"
#include "maps/map_edit.hpp"
#include "maps/ply_file.hpp"
#include "merging/map_merge.hpp"
#include "number_list.hpp"
#include "report/map_files.hpp"
#include "report/map_picture.hpp"
#include "scores/tum_file.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"
#include "version.hpp"

namespace ddtool {
namespace {

constexpr const char* merge_word = "merge";

struct MapRequest {
    std::vector<std::string> words;
    std::string crop;
    std::string origin;
    std::size_t ghosts = 5;
    bool without_ghosts = false;
    std::string draw;
    std::string folder;
    std::string out;
    bool as_json = false;
};

Trajectory path_of(const maps::SavedMap& map) {
    Trajectory path;
    for (const maps::MapNode& node : map.nodes) {
        path.push_back({node.scan.stamp_ns, node.pose});
    }
    return path;
}

std::size_t points_in(const maps::SavedMap& map) {
    std::size_t points = 0;
    for (const maps::MapNode& node : map.nodes) {
        points += node.scan.points.size();
    }
    return points;
}

Json map_json(const std::string& file, const maps::SavedMap& map, const MapRaster& raster) {
    const auto cells = [&](std::int8_t value) { return std::ranges::count(raster.cells, value); };
    Json drives = Json::array();
    for (std::size_t number = 0; number < map.drives.size(); ++number) {
        const maps::Drive& drive = map.drives[number];
        Json entry{
            {"log", drive.log},
            {"scans", std::ranges::count(map.nodes, number, [](const maps::MapNode& node) { return node.drive; })},
            {"odometry_scale", nullptr},
            {"gyro_bias_rad_per_s", nullptr}};
        if (drive.odometry) {
            entry["odometry_scale"] = drive.odometry->scale;
            entry["gyro_bias_rad_per_s"] = drive.odometry->bias_rad_per_s;
        }
        drives.push_back(std::move(entry));
    }
    const double cell_m2 = raster.cell_size_m * raster.cell_size_m;
    return {{"file", file},
            {"program", map.program},
            {"width_m", raster.width_m()},
            {"height_m", raster.height_m()},
            {"lower_left", {raster.origin_m.x_m, raster.origin_m.y_m}},
            {"cell_size_m", raster.cell_size_m},
            {"free_m2", static_cast<double>(cells(MapRaster::free)) * cell_m2},
            {"occupied_cells", cells(MapRaster::occupied)},
            {"scans", map.nodes.size()},
            {"points", points_in(map)},
            {"path_m", path_length_m(path_of(map))},
            {"edges", map.edges.size()},
            {"drives", drives}};
}

std::string map_text(const Json& about) {
    const auto number = [&](const char* key, int decimals) {
        return fixed_text(about.at(key).get<double>(), decimals);
    };
    const auto count = [&](const char* key) { return std::to_string(about.at(key).get<std::size_t>()); };
    std::string text = "map      " + number("width_m", 1) + " m x " + number("height_m", 1) +
                       " m, lower left corner (" + fixed_text(about.at("lower_left").at(0), 2) + ", " +
                       fixed_text(about.at("lower_left").at(1), 2) + "), " + number("free_m2", 1) +
                       " m2 free, cells of " + number("cell_size_m", 3) + " m\n";
    if (about.at("scans") == 0) {
        return text + "scans    none: a picture, which can be localised in, but not drawn anew\n";
    }
    text += "scans    " + count("scans") + " with " + count("points") + " points, along " + number("path_m", 1) +
            " m; " + count("edges") + " edges of a pose graph\n";
    for (const Json& drive : about.at("drives")) {
        text +=
            "drive    " + drive.at("log").get<std::string>() + ": " +
            std::to_string(drive.at("scans").get<std::size_t>()) + " scans" +
            (drive.at("odometry_scale").is_null() ? ""
                                                  : ", odometry's scale " + fixed_text(drive.at("odometry_scale"), 4)) +
            "\n";
    }
    return text + "written  by " + about.at("program").get<std::string>() + "\n";
}

/// Applies the changes that the options ask for. Returns whether there were any.
bool change(maps::SavedMap& map, const MapRequest& request) {
    if (!request.crop.empty()) {
        const std::vector<double> limits = number_list("--crop", request.crop, "x_min,y_min,x_max,y_max", 4);
        if (!(limits[0] < limits[2] && limits[1] < limits[3])) {
            throw UsageError("--crop: expected x_min below x_max, and y_min below y_max");
        }
        const std::size_t before = map.nodes.size();
        const std::size_t left = maps::crop(map, {limits[0], limits[1], limits[2], limits[3]});
        log_info("cropped: " + std::to_string(left) + " of " + std::to_string(before) + " scans are left");
    }
    if (request.without_ghosts) {
        if (request.ghosts < 1 || request.ghosts > maps::most_see_throughs) {
            throw UsageError("--remove-ghosts: expected 1 to " + std::to_string(maps::most_see_throughs) + " scans");
        }
        const std::size_t removed = maps::remove_ghosts(map, static_cast<int>(request.ghosts));
        log_info("ghosts: " + std::to_string(removed) + " occupied cells removed, through which " +
                 std::to_string(request.ghosts) + " later scans saw");
    }
    if (!request.origin.empty()) {
        maps::set_origin(map, pose_option("--origin", request.origin));
    }
    return !request.crop.empty() || request.without_ghosts || !request.origin.empty();
}

void export_map(const maps::SavedMap& map, const MapRaster& raster, const std::filesystem::path& place) {
    const std::filesystem::path folder = made_folder(place);
    write_map_files(folder, "map", raster);
    write_map_picture(folder / "map.png", raster, path_of(map));
    std::string names = "map.pgm, map.yaml, map.png";
    if (!map.nodes.empty()) {
        write_tum(folder / "trajectory.tum", path_of(map));
        graph::write_g2o(folder / "graph.g2o", maps::graph_of(map));
        maps::write_ply(folder / "points.ply", map);
        names += ", trajectory.tum, graph.g2o, points.ply";
    }
    log_info("written to " + folder.string() + ": " + names);
}

/// The map of two files. What cannot be merged is told with both their names.
maps::SavedMap merged_map(const std::string& first_file, const std::string& second_file) {
    const maps::SavedMap first = maps::read_any_map(first_file);
    const maps::SavedMap second = maps::read_any_map(second_file);
    try {
        merging::Merged merged = merging::merged(first, second);
        const Pose2& origin = merged.first_from_second;
        log_info("merged: the origin of " + second_file + " lies at (" + fixed_text(origin.x_m, 2) + ", " +
                 fixed_text(origin.y_m, 2) + ", " + fixed_text(origin.theta_rad, 3) + " rad) of " + first_file + "; " +
                 std::to_string(merged.agreeing) + " of " + std::to_string(merged.compared) +
                 " windows of it overlap and agree, and " + fixed_text(100.0 * merged.agreed, 1) +
                 " % of the walls that both show; " + std::to_string(merged.seams) +
                 " edges between them, which moved the poses of " + first_file + " by up to " +
                 fixed_text(merged.most_moved_m, 3) + " m");
        return std::move(merged.map);
    } catch (const MapTooLarge&) {
        throw;
    } catch (const Error& error) {
        throw Error(first_file + " and " + second_file + " cannot be merged: " + error.what());
    }
}

/// The map that the words of the command line name, and how messages call it.
std::pair<maps::SavedMap, std::string> wanted_map(MapRequest& request) {
    const std::vector<std::string>& words = request.words;
    if (words.size() == 1) {
        return {maps::read_any_map(words[0]), words[0]};
    }
    if (words[0] != merge_word) {
        throw UsageError("map: unexpected argument '" + words[1] + "'; expected one FILE, or merge A B OUT");
    }
    if (words.size() < 3 || words.size() > 4) {
        throw UsageError("map merge: " + std::to_string(words.size() - 1) +
                         " files; expected the two maps and the file to write, or the two maps and --out");
    }
    if (words.size() == 4) {
        if (!request.out.empty()) {
            throw UsageError("map merge: " + words[3] + " and --out " + request.out + "; expected one file to write");
        }
        request.out = words[3];
    }
    if (request.out.empty() && request.draw.empty() && request.folder.empty()) {
        throw UsageError("map merge: the map would be written nowhere; expected OUT, --export or --draw");
    }
    return {merged_map(words[1], words[2]), request.out.empty() ? words[1] + " + " + words[2] : request.out};
}

ExitCode map(MapRequest request) {
    auto [map, name] = wanted_map(request);
    const bool changed = change(map, request);
    if (changed && request.out.empty() && request.draw.empty() && request.folder.empty()) {
        throw UsageError("map: the map would be changed, but written nowhere; expected --out, --export or --draw");
    }
    const MapRaster raster = map_raster(map.grid);
    if (!request.out.empty()) {
        maps::write_map(request.out, program_version(), map);
        log_info("written: " + request.out);
    }
    if (!request.folder.empty()) {
        export_map(map, raster, request.folder);
    }
    if (!request.draw.empty()) {
        write_map_picture(request.draw, raster, path_of(map));
        log_info("written: " + request.draw);
    }
    const Json about = map_json(name, map, raster);
    std::cout << (request.as_json ? about.dump(2) + "\n" : map_text(about));
    return ExitCode::done;
}

}  // namespace

Command map_command() {
    const auto request = std::make_shared<MapRequest>();
    return {.name = "map",
            .summary = "What is in a saved map; draw, export, crop, clean it, merge two",
            .example = "ddtool map run/map.ddmap --remove-ghosts --out clean.ddmap",
            .options =
                {
                    {"FILE", &request->words,
                     std::string(saved_map_help) + "; or merge A B OUT: make one map of two that show the same place "
                                                   "in part",
                     "FILE", Presence::required},
                    {"--crop", &request->crop, "Keep only what lies in this rectangle, in metres in the map",
                     "X_MIN,Y_MIN,X_MAX,Y_MAX"},
                    {.name = "--remove-ghosts",
                     .value = &request->ghosts,
                     .help = "Remove what so many later scans saw through, such as people and doors that opened",
                     .type = "SCANS",
                     .alone = "5",
                     .given = &request->without_ghosts},
                    {"--origin", &request->origin, "The pose in the map that becomes its origin: metres, and radians",
                     "X,Y,YAW"},
                    {"--draw", &request->draw, "Picture of the map with the path on it to write", "FILE.png"},
                    {"--export", &request->folder,
                     "Folder for map.pgm with map.yaml, map.png, trajectory.tum, graph.g2o and points.ply", "DIR"},
                    {"--out", &request->out, "Map file to write, with the changes", "FILE.ddmap"},
                    {"--json", &request->as_json, "Print JSON instead of a summary"},
                },
            .run = [request](const Json&) { return map(*request); }};
}

}  // namespace ddtool

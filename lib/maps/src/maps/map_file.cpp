#include "maps/map_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <optional>
#include <span>

#include "ddtool/base/error.hpp"
#include "logs/containers/mcap_format.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/messages/ros_codec.hpp"

namespace ddtool::maps {
namespace {

constexpr const char* header_topic = "/map/header";
constexpr const char* scan_topic = "/map/scan";
constexpr const char* drive_topic = "/map/drive";
constexpr const char* graph_topic = "/map/graph";
constexpr const char* tile_topic = "/map/tile";
constexpr const char* end_topic = "/map/end";

/// Farther poses are not on any map: OccupancyGrid::most_patches is some square kilometres.
constexpr double farthest_m = 1e6;

RosPose2D to_message(const Pose2& pose) { return {pose.x_m, pose.y_m, pose.theta_rad}; }

RosMapScan to_message(const graph::Node& scan, std::uint32_t drive) {
    graph::PackedScan::Columns columns = scan.points.columns();
    RosMapScan message{.stamp = {scan.stamp_ns},
                       .drive = drive,
                       .odometry = to_message(scan.odom_from_robot),
                       .duration = scan.duration_s,
                       .degree = scan.degree,
                       .lidars = {columns.origin_m.x_m, columns.origin_m.y_m},
                       .beginnings = {},
                       .unit = columns.step_m,
                       .x = std::move(columns.x),
                       .y = std::move(columns.y),
                       .normal = std::move(columns.normal),
                       .along = std::move(columns.along),
                       .order_gap = std::move(columns.order_gap)};
    for (const ScanPoints::Joined& joined : columns.joined) {
        message.lidars.insert(message.lidars.end(), {joined.origin_m.x_m, joined.origin_m.y_m});
        message.beginnings.push_back(static_cast<std::uint32_t>(joined.begin));
    }
    return message;
}

RosMapDrive to_message(const Drive& drive) {
    RosMapDrive message{.log = drive.log, .has_odometry = drive.odometry ? 1U : 0U, .odometry = {}};
    if (drive.odometry) {
        const OdometryState& state = *drive.odometry;
        message.odometry = {
            state.scale,           state.scale_variance,     state.bias_rad_per_s,    state.bias_variance,
            state.along_per_m.sum, state.along_per_m.chords, state.along_per_rad.sum, state.along_per_rad.chords,
            state.turn_per_m.sum,  state.turn_per_m.chords,  state.turn_per_rad.sum,  state.turn_per_rad.chords};
    }
    return message;
}

RosMapEdge to_message(const MapEdge& edge) {
    RosMapEdge message{.kind = static_cast<std::uint32_t>(edge.kind),
                       .from = static_cast<std::uint32_t>(edge.edge.from),
                       .to = static_cast<std::uint32_t>(edge.edge.to),
                       .measured = to_message(edge.edge.measured),
                       .information = {},
                       .weight = edge.edge.weight};
    for (int row = 0; row < 3; ++row) {
        for (int column = row; column < 3; ++column) {
            message.information.push_back(edge.edge.information(row, column));
        }
    }
    return message;
}

/// Empty if nothing in the tile was observed.
std::optional<RosMapTile> tile_at(const OccupancyGrid& grid, int column, int row) {
    RosMapTile tile{.column = column, .row = row, .log_odds = {}, .means = {}};
    bool observed = false;
    for (int y = row * Patch::size_cells; y < (row + 1) * Patch::size_cells; ++y) {
        for (int x = column * Patch::size_cells; x < (column + 1) * Patch::size_cells; ++x) {
            const std::int8_t log_odds = grid.log_odds({x, y});
            observed = observed || log_odds != Patch::unknown;
            tile.log_odds.push_back(log_odds);
            if (log_odds > 0) {
                const NearestPoint mean = grid.nearest({x, y});
                tile.means.insert(tile.means.end(), {mean.x, mean.y});
            }
        }
    }
    return observed ? std::optional(std::move(tile)) : std::nullopt;
}

class MapReader {
public:
    MapReader(const std::filesystem::path& file, MapParts parts, std::uint64_t most_memory_mib)
        : file_(file.string()),
          parts_(parts),
          most_memory_mib_(most_memory_mib),
          reader_(file, [this](const LogProblem& problem) {
              if (problem_.empty()) {
                  problem_ = problem.what;
              }
          }) {}

    SavedMap read() {
        while (true) {
            const std::optional<McapMessage> message = reader_.next();
            if (!problem_.empty()) {
                throw Error(problem_ + "; expected a whole map file, which " + file_ + " is no longer");
            }
            if (!message) {
                break;
            }
            take(*message);
        }
        if (!map_) {
            throw Error(file_ + ": no map in it; expected a file map.ddmap as ddtool slam writes it");
        }
        if (!end_ || end_->scans != scans_ || end_->drives != map_->drives.size() || end_->tiles != tiles_) {
            throw Error(file_ + ": " + (end_ ? "parts of the map are missing" : "the map ends without its end") +
                        "; expected a whole map file");
        }
        finish_nodes();
        return std::move(*map_);
    }

private:
    void take(const McapMessage& message) {
        const std::string& topic = message.channel->topic;
        offset_ = message.file_offset;
        if (!map_) {
            if (topic != header_topic) {
                fail("a message on " + topic, "a map file, which begins with " + std::string(header_topic));
            }
            take_header(decoded<RosMapHeader>(message));
        } else if (end_) {
            fail("a message behind the end of the map", "none");
        } else if (topic == scan_topic) {
            ++scans_;
            if (parts_ == MapParts::all) {
                take_scan(decoded<RosMapScan>(message));
            }
        } else if (topic == drive_topic) {
            take_drive(decoded<RosMapDrive>(message));
        } else if (topic == graph_topic) {
            if (parts_ == MapParts::all) {
                take_graph(decoded<RosMapGraph>(message));
            }
        } else if (topic == tile_topic) {
            ++tiles_;
            take_tile(decoded<RosMapTile>(message));
        } else if (topic == end_topic) {
            end_ = decoded<RosMapEnd>(message);
        }  // Later versions of this format may add topics that this one need not know.
    }

    template <typename Message>
    Message decoded(const McapMessage& message) const {
        if (message.channel->schema.name != Message::type_name) {
            fail("a message of type '" + message.channel->schema.name + "' on " + message.channel->topic,
                 Message::type_name);
        }
        if (std::optional<Message> content = decode_cdr<Message>(message.data)) {
            return std::move(*content);
        }
        fail("a damaged message on " + message.channel->topic, "one of type " + std::string(Message::type_name));
    }

    void take_header(RosMapHeader header) {
        if (header.format == 0 || header.format > map_format) {
            fail("a map of format " + std::to_string(header.format),
                 "format 1 to " + std::to_string(map_format) + ", which this version of ddtool reads");
        }
        const bool sound = header.cell_size >= 0.005 && header.cell_size <= 1.0 && in(header.hit_step, 1, 27) &&
                           in(header.free_step, 1, 27) && in(header.min_log_odds, -100, -1) &&
                           in(header.max_log_odds, 1, 100);
        if (!sound) {
            fail("cells of " + std::to_string(header.cell_size) + " m with evidence in steps of " +
                     std::to_string(header.hit_step) + " and " + std::to_string(header.free_step) + " from " +
                     std::to_string(header.min_log_odds) + " to " + std::to_string(header.max_log_odds),
                 "values that the settings under filter.grid may have");
        }
        map_.emplace(OccupancySettings{.cell_size_m = header.cell_size,
                                       .hit_step = header.hit_step,
                                       .free_step = header.free_step,
                                       .min_log_odds = header.min_log_odds,
                                       .max_log_odds = header.max_log_odds,
                                       .most_memory_mib = most_memory_mib_});
        map_->program = std::move(header.program);
        try {
            map_->settings = parse_json(header.settings, file_ + ", settings");
        } catch (const Json::exception& error) {
            fail(std::string("settings that are no JSON (") + error.what() + ")", "JSON");
        }
    }

    static bool in(std::int32_t value, std::int32_t least, std::int32_t most) {
        return value >= least && value <= most;
    }

    void take_scan(RosMapScan message) {
        MapNode node;
        node.drive = message.drive;
        node.scan.stamp_ns = message.stamp.ns;
        node.scan.scan = map_->nodes.size();
        node.scan.odom_from_robot = pose_of(message.odometry, std::numeric_limits<double>::max());
        if (!(message.duration >= 0.0 && std::isfinite(message.duration) && message.degree >= 0.0 &&
              message.degree <= 1.0)) {
            fail("a scan with the duration " + std::to_string(message.duration) + " s and the degree " +
                     std::to_string(message.degree),
                 "a duration of 0 or more, and a degree in 0..1");
        }
        node.scan.duration_s = message.duration;
        node.scan.degree = message.degree;
        if (message.lidars.size() != 2 * message.beginnings.size() + 2) {
            fail("a scan of " + std::to_string(message.lidars.size()) + " coordinates of lidars", "two for each lidar");
        }
        graph::PackedScan::Columns columns{.origin_m = {message.lidars[0], message.lidars[1]},
                                           .step_m = message.unit,
                                           .x = std::move(message.x),
                                           .y = std::move(message.y),
                                           .normal = std::move(message.normal),
                                           .along = std::move(message.along),
                                           .order_gap = std::move(message.order_gap),
                                           .joined = {}};
        for (std::size_t i = 0; i < message.beginnings.size(); ++i) {
            columns.joined.push_back({{message.lidars[2 * i + 2], message.lidars[2 * i + 3]}, message.beginnings[i]});
        }
        try {
            node.scan.points = graph::PackedScan::from(columns);
        } catch (const Error& error) {
            throw Error(place() + error.what());
        }
        map_->nodes.push_back(std::move(node));
    }

    void take_drive(RosMapDrive message) {
        Drive drive{.log = std::move(message.log), .odometry = {}};
        if (message.has_odometry != 0) {
            const std::vector<double>& state = message.odometry;
            constexpr std::size_t numbers = 12;
            bool sound = state.size() == numbers;
            for (std::size_t i = 0; sound && i < numbers; ++i) {
                const bool any_sign = i == 2;  // the bias
                sound = std::isfinite(state[i]) && (any_sign || state[i] >= 0.0);
            }
            constexpr std::array<std::size_t, 4> numbers_of_chords{5, 7, 9, 11};
            sound = sound && state[0] > 0.0 && std::ranges::all_of(numbers_of_chords, [&](std::size_t i) {
                        return state[i] > 0.0 && state[i - 1] > 0.0;
                    });
            if (!sound) {
                fail("a learnt odometry of " + std::to_string(state.size()) + " numbers",
                     "12 finite ones, which are positive but for the fourth and third");
            }
            drive.odometry = OdometryState{.scale = state[0],
                                           .scale_variance = state[1],
                                           .bias_rad_per_s = state[2],
                                           .bias_variance = state[3],
                                           .along_per_m = {state[4], state[5]},
                                           .along_per_rad = {state[6], state[7]},
                                           .turn_per_m = {state[8], state[9]},
                                           .turn_per_rad = {state[10], state[11]}};
        }
        map_->drives.push_back(std::move(drive));
    }

    void take_graph(const RosMapGraph& message) {
        for (const RosPose2D& pose : message.poses) {
            poses_.push_back(pose_of(pose, farthest_m));
        }
        for (const RosMapEdge& edge : message.edges) {
            const bool sound =
                edge.kind <= static_cast<std::uint32_t>(MapEdge::Kind::loop) && edge.from < poses_.size() &&
                edge.to < poses_.size() && edge.information.size() == 6 &&
                std::ranges::all_of(edge.information, [](double value) { return std::isfinite(value); }) &&
                edge.weight > 0.0 && edge.weight <= 1.0;
            if (!sound) {
                fail("an edge of kind " + std::to_string(edge.kind) + " from node " + std::to_string(edge.from) +
                         " to node " + std::to_string(edge.to),
                     "kinds 0 to 2 between two of the " + std::to_string(poses_.size()) +
                         " nodes, six finite numbers and a weight in 0..1");
            }
            MapEdge kept{static_cast<MapEdge::Kind>(edge.kind),
                         {.from = edge.from, .to = edge.to, .measured = pose_of(edge.measured, farthest_m)}};
            std::size_t next = 0;
            for (int row = 0; row < 3; ++row) {
                for (int column = row; column < 3; ++column) {
                    kept.edge.information(row, column) = kept.edge.information(column, row) = edge.information[next++];
                }
            }
            kept.edge.weight = edge.weight;
            map_->edges.push_back(kept);
        }
    }

    void take_tile(const RosMapTile& tile) {
        constexpr auto most = static_cast<std::int32_t>(most_cells / Patch::size_cells) - 1;
        const std::int32_t least_odds = map_->grid.settings().min_log_odds;
        const std::int32_t most_odds = map_->grid.settings().max_log_odds;
        const auto occupied =
            static_cast<std::size_t>(std::ranges::count_if(tile.log_odds, [](std::int8_t value) { return value > 0; }));
        const bool sound =
            in(tile.column, -most, most) && in(tile.row, -most, most) && tile.log_odds.size() == Patch::cell_count &&
            tile.means.size() == 2 * occupied &&
            std::ranges::all_of(tile.means, [](std::int8_t value) { return value >= -16 && value <= 15; }) &&
            std::ranges::all_of(tile.log_odds, [&](std::int8_t value) {
                return value == Patch::unknown || in(value, least_odds, most_odds);
            });
        if (!sound) {
            fail("a tile at column " + std::to_string(tile.column) + ", row " + std::to_string(tile.row) + " of " +
                     std::to_string(tile.log_odds.size()) + " cells and " + std::to_string(tile.means.size()) +
                     " coordinates",
                 "256 cells within the limits, and two coordinates in -16..15 for each occupied one");
        }
        const int x0 = tile.column * Patch::size_cells;
        const int y0 = tile.row * Patch::size_cells;
        map_->grid.reserve({x0, y0, x0 + Patch::size_cells, y0 + Patch::size_cells});
        std::size_t mean = 0;
        for (int cell = 0; cell < static_cast<int>(Patch::cell_count); ++cell) {
            const std::int8_t log_odds = tile.log_odds[static_cast<std::size_t>(cell)];
            NearestPoint point;
            if (log_odds > 0) {
                point = {tile.means[mean], tile.means[mean + 1]};
                mean += 2;
            }
            map_->grid.set({x0 + cell % Patch::size_cells, y0 + cell / Patch::size_cells}, log_odds, point);
        }
    }

    /// Gives the scans their poses; what has none is no part of the map.
    void finish_nodes() {
        if (parts_ != MapParts::all) {
            return;
        }
        if (poses_.size() > map_->nodes.size()) {
            throw Error(file_ + ": " + std::to_string(poses_.size()) + " poses of " +
                        std::to_string(map_->nodes.size()) + " scans; expected no more poses than scans");
        }
        map_->nodes.resize(poses_.size());
        for (std::size_t node = 0; node < poses_.size(); ++node) {
            if (map_->nodes[node].drive >= map_->drives.size()) {
                throw Error(file_ + ": a scan of drive " + std::to_string(map_->nodes[node].drive) +
                            "; expected one of the " + std::to_string(map_->drives.size()) + " drives");
            }
            map_->nodes[node].pose = poses_[node];
        }
    }

    Pose2 pose_of(const RosPose2D& pose, double farthest) const {
        if (!(std::abs(pose.x) <= farthest && std::abs(pose.y) <= farthest && std::isfinite(pose.theta))) {
            fail("a pose at (" + std::to_string(pose.x) + ", " + std::to_string(pose.y) + ", " +
                     std::to_string(pose.theta) + ")",
                 "finite numbers, and less than 1000 km");
        }
        return {pose.x, pose.y, wrap_angle(pose.theta)};
    }

    [[nodiscard]] std::string place() const { return file_ + ": near byte " + std::to_string(offset_) + ": "; }

    [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
        throw Error(place() + found + "; expected " + expected);
    }

    std::string file_;
    MapParts parts_;
    std::uint64_t most_memory_mib_;
    std::string problem_;
    McapReader reader_;
    std::optional<SavedMap> map_;
    std::vector<Pose2> poses_;
    std::optional<RosMapEnd> end_;
    std::uint64_t scans_ = 0;
    std::uint64_t tiles_ = 0;
    std::uint64_t offset_ = 0;
};

}  // namespace

MapFileWriter::MapFileWriter(const std::filesystem::path& file, const std::string& program, const Json& settings,
                             const OccupancySettings& cells)
    : file_(file) {
    file_.write(header_topic, 0,
                RosMapHeader{.format = map_format,
                             .program = program,
                             .settings = settings.dump(),
                             .cell_size = cells.cell_size_m,
                             .hit_step = cells.hit_step,
                             .free_step = cells.free_step,
                             .min_log_odds = cells.min_log_odds,
                             .max_log_odds = cells.max_log_odds});
}

void MapFileWriter::add(const graph::Node& scan, std::uint32_t drive) {
    stamp_ns_ = scan.stamp_ns;
    ++scans_;
    file_.write(scan_topic, stamp_ns_, to_message(scan, drive));
}

void MapFileWriter::finish(const std::vector<Drive>& drives, const std::vector<Pose2>& poses,
                           const std::vector<MapEdge>& edges, const OccupancyGrid& grid) {
    for (const Drive& drive : drives) {
        file_.write(drive_topic, stamp_ns_, to_message(drive));
    }
    RosMapGraph graph;
    for (const Pose2& pose : poses) {
        graph.poses.push_back(to_message(pose));
    }
    for (const MapEdge& edge : edges) {
        graph.edges.push_back(to_message(edge));
    }
    file_.write(graph_topic, stamp_ns_, graph);
    const CellBox box = grid.observed_box();
    std::uint64_t tiles = 0;
    for (int row = box.y_min >> Patch::size_bits; row < box.y_max >> Patch::size_bits; ++row) {
        for (int column = box.x_min >> Patch::size_bits; column < box.x_max >> Patch::size_bits; ++column) {
            if (const std::optional<RosMapTile> tile = tile_at(grid, column, row)) {
                file_.write(tile_topic, stamp_ns_, *tile);
                ++tiles;
            }
        }
    }
    file_.write(end_topic, stamp_ns_, RosMapEnd{.scans = scans_, .drives = drives.size(), .tiles = tiles});
    file_.close();
}

void write_map(const std::filesystem::path& file, const std::string& program, const SavedMap& map) {
    MapFileWriter writer(file, program, map.settings, map.grid.settings());
    std::vector<Pose2> poses;
    for (const MapNode& node : map.nodes) {
        writer.add(node.scan, node.drive);
        poses.push_back(node.pose);
    }
    writer.finish(map.drives, poses, map.edges, map.grid);
}

bool looks_like_map_file(const std::filesystem::path& file) {
    std::array<char, mcap_magic.size()> start{};
    std::ifstream(file, std::ios::binary).read(start.data(), start.size());
    return std::ranges::equal(std::as_bytes(std::span(start)), mcap_magic);
}

SavedMap read_map(const std::filesystem::path& file, MapParts parts, std::uint64_t most_memory_mib) {
    return MapReader(file, parts, most_memory_mib).read();
}

}  // namespace ddtool::maps

#include "run/run_folder.hpp"

#include <utility>

#include "graph/g2o_file.hpp"
#include "report/map_files.hpp"
#include "report/map_picture.hpp"
#include "system/atomic_file.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

constexpr const char* result_name = "result.mcap";
constexpr const char* snapshots_name = "snapshots.mcap";
constexpr const char* degeneracy_name = "degeneracy.csv";
constexpr const char* online_name = "trajectory_online.tum";
constexpr const char* filter_path_name = "trajectory_filter.tum";
constexpr const char* graph_name = "graph.g2o";
constexpr const char* nodes_name = "graph_nodes.csv";
constexpr const char* map_file_name = "map.ddmap";
constexpr const char* page_name = "report.html";

}  // namespace

RunFolder::RunFolder(std::filesystem::path folder, bool with_snapshots)
    : folder_(made_folder(std::move(folder))),
      result_(folder_ / result_name),
      degeneracy_(folder_ / degeneracy_name),
      online_(folder_ / online_name) {
    if (with_snapshots) {
        snapshots_.emplace(folder_ / snapshots_name);
    }
}

void RunFolder::add(const SensorFrame& frame, const std::optional<Update>& update, const ParticleFilter& filter) {
    const StageTimer timer(write_s_);
    result_.add(frame, update, filter);
    online_.add({frame.scan.stamp_ns, filter.pose()});
    if (!update) {
        return;
    }
    const UpdateSummary summary = summary_of(*update);
    course_.add(*update, summary);
    degeneracy_.add(summary);
    if (snapshots_) {
        snapshots_->write(update->matched, update->degeneracy);
    }
}

void RunFolder::finish(const FilterRun& run, const MapRaster& map) {
    const StageTimer timer(write_s_);
    result_.finish(map, run.trajectory);
    complete_streams();
    write_trajectory("trajectory.tum", run.trajectory);
    write_trajectory("ground_truth.tum", run.ground_truth);
    write_map_files(folder_, "map", map);
    files_.insert(files_.end(), {"map.pgm", "map.yaml"});
    write_map_picture(place("map.png"), map, run.trajectory);
    write_degeneracy_picture(place("degeneracy.png"), course_.updates(), map, run.trajectory);
}

void RunFolder::begin_map_file(const std::string& program, const Json& settings, const OccupancySettings& cells) {
    map_file_.emplace(folder_ / map_file_name, program, settings, cells);
}

void RunFolder::add(const graph::Node& node) {
    const StageTimer timer(write_s_);
    constexpr std::uint32_t only_drive = 0;
    map_file_->add(node, only_drive);
    node_scans_.push_back(node.scan);
}

void RunFolder::finish_map_file(const std::string& log, const FilterRun& run, const graph::PoseGraph* graph) {
    const StageTimer timer(write_s_);
    std::vector<Pose2> poses;
    for (const std::size_t scan : node_scans_) {
        if (scan < run.trajectory.size()) {
            poses.push_back(run.trajectory[scan].pose);
        }
    }
    map_file_->finish({{.log = log, .odometry = run.odometry}}, poses,
                      graph == nullptr ? std::vector<maps::MapEdge>() : maps::edges_of(*graph), run.map);
    files_.emplace_back(map_file_name);
}

void RunFolder::write_map_file(const std::string& program, const maps::SavedMap& map) {
    const StageTimer timer(write_s_);
    maps::write_map(place(map_file_name), program, map);
}

void RunFolder::write_back_end(const BackEndResults* results) {
    if (results == nullptr) {
        for (const char* name : {filter_path_name, graph_name, nodes_name}) {
            std::filesystem::remove(folder_ / name);
        }
        return;
    }
    const StageTimer timer(write_s_);
    write_trajectory(filter_path_name, results->by_filter);
    graph::write_g2o(place(graph_name), results->smoothed.graph);
    write_graph_nodes(place(nodes_name), results->smoothed);
}

void RunFolder::write_json(const std::string& name, const Json& content) {
    write_file(place(name), content.dump(2) + "\n");
}

bool RunFolder::write_page(const std::function<report::Page()>& make) {
    const bool written = report::write_page(folder_ / page_name, make);
    if (written) {
        files_.emplace_back(page_name);
    }
    return written;
}

void RunFolder::complete_streams() {
    result_.close();
    degeneracy_.close();
    online_.close();
    files_.insert(files_.end(), {result_name, degeneracy_name, online_name});
    if (snapshots_) {
        snapshots_->close();
        files_.emplace_back(snapshots_name);
    } else {
        std::filesystem::remove(folder_ / snapshots_name);
    }
    if (!map_file_) {
        std::filesystem::remove(folder_ / map_file_name);
    }
}

void RunFolder::write_trajectory(const std::string& name, const Trajectory& trajectory) {
    if (trajectory.empty()) {
        std::filesystem::remove(folder_ / name);
    } else {
        write_tum(place(name), trajectory);
    }
}

std::filesystem::path RunFolder::place(const std::string& name) {
    files_.push_back(name);
    return folder_ / name;
}

}  // namespace ddtool

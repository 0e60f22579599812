#include "results/run_folder.hpp"

#include <system_error>
#include <utility>

#include "base/atomic_file.hpp"
#include "base/error.hpp"
#include "geometry/tum_file.hpp"
#include "results/map_files.hpp"
#include "results/map_picture.hpp"

namespace ddtool {
namespace {

std::filesystem::path created(std::filesystem::path folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) {
        throw Error(folder.string() + ": cannot create the folder: " + failure.message());
    }
    return folder;
}

}  // namespace

RunFolder::RunFolder(std::filesystem::path folder)
    : folder_(created(std::move(folder))), result_(folder_ / "result.mcap") {}

void RunFolder::finish(const FilterRun& run, const MapRaster& map) {
    result_.finish(map, run.trajectory);
    result_.close();
    files_.emplace_back("result.mcap");
    write_trajectory("trajectory.tum", run.trajectory);
    write_trajectory("trajectory_online.tum", run.online);
    write_trajectory("ground_truth.tum", run.ground_truth);
    write_map_files(folder_, "map", map);
    files_.insert(files_.end(), {"map.pgm", "map.yaml"});
    write_map_picture(place("map.png"), map, run.trajectory);
}

void RunFolder::write_json(const std::string& name, const Json& content) {
    write_file(place(name), content.dump(2) + "\n");
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

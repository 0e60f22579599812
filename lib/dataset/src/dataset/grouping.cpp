#include "dataset/grouping.hpp"

namespace ddtool::dataset {
namespace {

std::string or_dash(const std::string& text) { return text.empty() ? "-" : text; }

std::string short_number(double number) {
    std::string text = std::to_string(number);
    text.erase(text.find_last_not_of('0') + 1);
    return text.ends_with('.') ? text + "0" : text;
}

GroupKey by_scene(const SampleRecord& /*sample*/, const RunEntry& run) { return {0.0, scene_family(run)}; }

GroupKey by_lidar(const SampleRecord& /*sample*/, const RunEntry& run) { return {0.0, or_dash(run.lidar)}; }

GroupKey by_odometry(const SampleRecord& /*sample*/, const RunEntry& run) { return {0.0, or_dash(run.odometry)}; }

GroupKey by_method(const SampleRecord& /*sample*/, const RunEntry& run) { return {0.0, or_dash(run.method)}; }

GroupKey by_update_distance(const SampleRecord& /*sample*/, const RunEntry& run) {
    return {run.update_distance_m, short_number(run.update_distance_m)};
}

GroupKey by_particles(const SampleRecord& sample, const RunEntry& /*run*/) {
    return {static_cast<double>(sample.particle_count), std::to_string(sample.particle_count)};
}

}  // namespace

const std::vector<Grouping>& groupings() {
    static const std::vector<Grouping> all{{"scene", by_scene},
                                           {"lidar", by_lidar},
                                           {"odometry", by_odometry},
                                           {"method", by_method},
                                           {"update distance [m]", by_update_distance},
                                           {"particles", by_particles}};
    return all;
}

std::string scene_family(const RunEntry& run) {
    const bool drawn = run.scene.starts_with("random:");
    return drawn ? run.scene.substr(0, run.scene.rfind(':')) : run.scene;
}

}  // namespace ddtool::dataset

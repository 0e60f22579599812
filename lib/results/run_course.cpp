#include "results/run_course.hpp"

#include "eval/association.hpp"
#include "particles/weights.hpp"

namespace ddtool {
namespace {

double total_s(const StageTimes& times) {
    return times.prepare_s + times.match_s + times.detect_s + times.correct_s + times.resample_s + times.map_s;
}

}  // namespace

void RunCourse::see(const ParticleSnapshot& swarm, const Degeneracy& degeneracy) {
    effective_size_ = effective_sample_size(weights_of(swarm.particles));
    worst_.offer(swarm, degeneracy);
}

void RunCourse::add(const Rbpf& filter) {
    const double now_s = total_s(filter.times());
    if (filter.updates() > 1) {
        updates_.push_back(filter.last_report());
        effective_sizes_.push_back(effective_size_);
        step_s_.push_back(now_s - filter_s_);
    }
    filter_s_ = now_s;
}

Trajectory places_of(const std::vector<UpdateReport>& updates, const Trajectory& path) {
    const StampIndex scans(path);
    Trajectory places;
    places.reserve(updates.size());
    for (const UpdateReport& update : updates) {
        const auto scan = scans.nearest(update.stamp_ns, 0.0);
        places.push_back({update.stamp_ns, scan ? path[*scan].pose : update.pose});
    }
    return places;
}

}  // namespace ddtool

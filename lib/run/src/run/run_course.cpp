#include "run/run_course.hpp"

#include "scores/association.hpp"
#include "swarm/weights.hpp"

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
    const double step_s = total_s(filter.times()) - filter_s_;
    filter_s_ += step_s;
    if (filter.updates() <= 1) {
        return;
    }
    if (seen_++ % every_ != 0) {
        updates_.back().resampled |= filter.last_report().resampled;
        return;
    }
    if (updates_.size() == most_) {
        halve();
    }
    updates_.push_back(filter.last_report());
    effective_sizes_.push_back(effective_size_);
    step_s_.push_back(step_s);
}

void RunCourse::halve() {
    const std::size_t left = most_ / 2;
    for (std::size_t row = 0; row < left; ++row) {
        updates_[row] = updates_[2 * row];
        updates_[row].resampled |= updates_[2 * row + 1].resampled;
        effective_sizes_[row] = effective_sizes_[2 * row];
        step_s_[row] = step_s_[2 * row];
    }
    updates_.resize(left);
    effective_sizes_.resize(left);
    step_s_.resize(left);
    every_ *= 2;
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

#include "run/worst_moments.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool {
namespace {

bool ranks_before(const WorstMoments::Moment& a, const WorstMoments::Moment& b) { return a.degree > b.degree; }

}  // namespace

WorstMoments::WorstMoments(std::size_t most, double apart_s) : most_(most), apart_s_(apart_s) {}

void WorstMoments::offer(const ParticleSnapshot& swarm, const Degeneracy& degeneracy) {
    const double degree = degeneracy.degree;
    const auto is_near = [&](const Moment& moment) {
        return 1e-9 * std::abs(static_cast<double>(moment.swarm.stamp_ns - swarm.stamp_ns)) < apart_s_;
    };
    const auto outranks = [&](const Moment& moment) { return is_near(moment) && moment.degree >= degree; };
    if (!(degree > 0.0) || std::any_of(kept_.begin(), kept_.end(), outranks)) {
        return;
    }
    std::erase_if(kept_, is_near);
    if (kept_.size() == most_) {
        const auto least = std::max_element(kept_.begin(), kept_.end(), ranks_before);
        if (least == kept_.end() || least->degree >= degree) {
            return;
        }
        kept_.erase(least);
    }
    kept_.push_back({swarm, degree});
}

std::vector<WorstMoments::Moment> WorstMoments::ranked() const {
    std::vector<Moment> moments = kept_;
    std::stable_sort(moments.begin(), moments.end(), ranks_before);
    return moments;
}

}  // namespace ddtool

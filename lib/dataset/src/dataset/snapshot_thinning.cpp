#include "dataset/snapshot_thinning.hpp"

#include <algorithm>

#include "ddtool/base/random.hpp"

namespace ddtool::dataset {
namespace {

enum ThinningPurpose : std::uint64_t { place_draw = 1, priority_draw = 2 };

}  // namespace

void SnapshotThinning::offer(const std::function<Sample()>& make) {
    const std::uint64_t position = offered_++;
    const std::uint64_t block = position / settings_.every;
    if (position % settings_.every != RandomStream({key_, place_draw, block}).index(settings_.every)) {
        return;
    }
    const std::uint64_t priority = RandomStream({key_, priority_draw, block})();
    if (kept_.size() == settings_.most_per_run) {
        if (priority > kept_.rbegin()->first) {
            return;
        }
        kept_.erase(std::prev(kept_.end()));
    }
    kept_.emplace(priority, Kept{position, make()});
}

std::vector<Sample> SnapshotThinning::take() {
    std::vector<Kept> kept;
    for (auto& [priority, each] : kept_) {
        kept.push_back(std::move(each));
    }
    std::sort(kept.begin(), kept.end(), [](const Kept& a, const Kept& b) { return a.position < b.position; });
    std::vector<Sample> samples;
    samples.reserve(kept.size());
    for (Kept& each : kept) {
        samples.push_back(std::move(each.sample));
    }
    return samples;
}

}  // namespace ddtool::dataset

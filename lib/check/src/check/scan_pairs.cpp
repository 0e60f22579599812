#include "check/scan_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace ddtool::check {
namespace {

/// Two scans that have fewer points in common tell nothing.
constexpr std::size_t least_points = 30;
/// Scans that lie so many kept scans apart were taken at different times.
constexpr std::size_t least_apart = 16;
/// Places nearer to each other than this see much of the same.
constexpr double nearby_m = 3.0;
/// So many earlier scans of the same place are compared with each scan.
constexpr std::size_t partners = 4;

class Comparison {
public:
    Comparison(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses) : scans_(scans), poses_(poses) {}

    void compare(std::size_t a, std::size_t b) {
        const Agreement found = agreement(scans_[a].sight, scans_[b].sight, between(poses_[a], poses_[b]));
        if (found.points() < least_points) {
            return;
        }
        shares_.push_back(found.contradicted());
        sum_.same += found.same;
        sum_.through += found.through;
    }

    [[nodiscard]] PairEvidence evidence() {
        if (shares_.empty()) {
            return {};
        }
        std::sort(shares_.begin(), shares_.end());
        const auto bad =
            std::count_if(shares_.begin(), shares_.end(), [](double share) { return share > PairEvidence::bad_pair; });
        return {.pairs = shares_.size(),
                .contradicted = sum_.contradicted(),
                .p90 = shares_[shares_.size() * 9 / 10],
                .bad = static_cast<double>(bad) / static_cast<double>(shares_.size())};
    }

private:
    const std::vector<KeptScan>& scans_;
    const std::vector<Pose2>& poses_;
    std::vector<double> shares_;
    Agreement sum_;
};

}  // namespace

PairEvidence neighbours(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses) {
    Comparison comparison(scans, poses);
    for (std::size_t a = 0; a + 1 < scans.size(); ++a) {
        comparison.compare(a, a + 1);
        if (a + 2 < scans.size()) {
            comparison.compare(a, a + 2);
        }
    }
    return comparison.evidence();
}

PairEvidence revisits(const std::vector<KeptScan>& scans, const std::vector<Pose2>& poses) {
    Comparison comparison(scans, poses);
    std::vector<std::size_t> near;
    for (std::size_t b = least_apart; b < scans.size(); ++b) {
        near.clear();
        for (std::size_t a = 0; a + least_apart <= b; ++a) {
            if (distance_m(poses[a], poses[b]) <= nearby_m) {
                near.push_back(a);
            }
        }
        const std::size_t taken = std::min(partners, near.size());
        for (std::size_t i = 0; i < taken; ++i) {
            comparison.compare(near[i * near.size() / taken], b);
        }
    }
    return comparison.evidence();
}

}  // namespace ddtool::check

#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ddtool/filter/rbpf.hpp"
#include "graph/coarse_map.hpp"
#include "localization/scan_fit.hpp"

namespace ddtool::localization {

/// A place where a scan fits the map.
struct FoundPlace {
    Pose2 pose;  ///< map_from_robot
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    double log_likelihood = 0.0;  ///< of the scan, as ScanMatch has it
    ScanFit fit;
};

struct FoundPlaces {
    std::vector<FoundPlace> places;  ///< the best first
    bool complete = true;            ///< whether these are all that fit about as well as the best
};

/// Finds all places of a whole map where a scan fits about as well as at the best one, by branch and bound over a
/// lattice of positions and headings (Hess et al., "Real-time loop closure in 2D lidar SLAM", ICRA 2016), which here
/// does not end at the best place: the others tell what else is possible. They are refined by the filter's matcher.
/// For one thread at a time.
class GlobalSearch {
public:
    GlobalSearch(const OccupancyGrid& map, const ScanMatcherSettings& matcher);

    FoundPlaces search(const ScanPoints& points);

private:
    static constexpr int levels = 6;  ///< level l has the best value of squares of 2^l cells

    struct Block {
        double bound = 0.0;
        int level = 0;
        int turn = 0;
        int x = 0;
        int y = 0;
    };
    struct Offsets {
        std::vector<int> x, y;  ///< in cells, of the points seen from the robot
    };

    void make_levels();
    [[nodiscard]] std::uint8_t value(int level, int x, int y) const;
    [[nodiscard]] double score(const Offsets& offsets, int level, int x, int y) const;
    [[nodiscard]] bool observed_in(int level, int x, int y) const;
    [[nodiscard]] std::vector<Block> coarse_places(const std::vector<Offsets>& turns, bool& complete) const;
    [[nodiscard]] Pose2 pose_of(const Block& block, std::size_t turns) const;
    void refine(const ScanPoints& points, FoundPlaces& found, const std::vector<Pose2>& starts);

    const OccupancyGrid& map_;
    ScanMatcher matcher_;
    std::optional<graph::CoarseMap> coarse_;
    int width_ = 0;  ///< of each level; the levels begin `margin` cells before the map
    int height_ = 0;
    std::vector<std::vector<std::uint8_t>> levels_;
};

}  // namespace ddtool::localization

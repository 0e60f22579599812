#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ddtool/filter/scan_matcher.hpp"
#include "localization/global_search.hpp"
#include "merging/map_side.hpp"
#include "merging/wall_agreement.hpp"

namespace ddtool::merging {

/// What a window of the second map says about where the second map lies in the first.
enum class Verdict {
    apart,       ///< it shows hardly anything that the first map shows, or is too far from a window that agrees
    agrees,      ///< it lies where the neighbours expect it, and its walls are those of the first map
    unclear,     ///< neither
    contradicts  ///< it lies on ground that the first map shows, and the walls differ
};

struct PlacedWindow {
    Pose2 pose;  ///< first_from_anchor
    WallAgreement walls;
    Verdict verdict = Verdict::apart;
};

/// A place of the second map in the first, window by window, since both maps may be bent.
struct Placement {
    std::vector<PlacedWindow> windows;  ///< one for each window of the second map that was compared
    double evidence = 0.0;              ///< log-odds for the walls being the same, against a fit by chance

    [[nodiscard]] std::size_t count(Verdict verdict) const;
};

/// Finds where a map lies in another. Windows of the second are looked for in all of the first by branch and bound;
/// each place found is a proposal of a transform, and the other windows that found a place by the same transform vote
/// for it. The best proposals are followed from window to window. The best of these must be agreed on by several
/// windows and contradicted by few, and every other one must be ruled out.
/// For one thread.
class OverlapSearch {
public:
    /// \param first_grid all of the first map drawn, with the cells of `settings`
    /// All must outlive this.
    OverlapSearch(const OccupancyGrid& first_grid, const MapSide& second, const RbpfSettings& settings);

    /// The windows of the second map that are compared, as numbers in its list.
    [[nodiscard]] const std::vector<std::size_t>& compared() const { return compared_; }

    /// Throws Error that says why in a few words if there is no place, or more than one.
    [[nodiscard]] Placement find();

private:
    /// A transform, and the window in which it was found.
    struct Proposal {
        std::size_t window = 0;  ///< in compared_
        Pose2 pose;              ///< first_from_anchor
        std::size_t votes = 0;
    };

    [[nodiscard]] std::vector<Proposal> proposals();
    [[nodiscard]] Placement followed(const Proposal& proposal);
    [[nodiscard]] PlacedWindow placed(std::size_t window, const Pose2& expected, double way_m);
    [[nodiscard]] double way_between_m(std::size_t a, std::size_t b) const;
    [[nodiscard]] bool is_ruled_out(const Placement& rival, const Placement& best) const;

    const OccupancyGrid& first_grid_;
    const MapSide& second_;
    std::vector<std::size_t> compared_;
    std::vector<std::shared_ptr<const graph::StretchMap>> local_maps_;  ///< of the windows that are compared
    localization::GlobalSearch search_;
    ScanMatcher matcher_;
};

}  // namespace ddtool::merging

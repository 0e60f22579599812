#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "trials.hpp"

namespace ddtool::matcher_bench {

inline constexpr double missing = std::numeric_limits<double>::quiet_NaN();

struct Mean {
    double value = missing;
    double standard_error = missing;
};

/// A mean of values that come in blocks. Values of a block may depend on each other, as matches do that share a piece
/// of the map; its standard error is that of independent blocks (cluster-robust).
class BlockMean {
public:
    void add(std::uint64_t block, double value);
    [[nodiscard]] std::size_t count() const { return count_; }
    /// Missing without values; the standard error is missing with fewer than two blocks.
    [[nodiscard]] Mean mean() const;

private:
    struct Sum {
        double values = 0.0;
        double count = 0.0;
    };
    std::map<std::uint64_t, Sum> blocks_;
    std::size_t count_ = 0;
};

enum Axis : std::size_t { along, across, heading, axis_count };

/// Of the matches whose scans hold the axis. All in m or rad.
struct AxisSummary {
    std::size_t held = 0;     ///< with fewer than AxisSummary::least_held all below is missing except for `believed`
    Mean bias;                ///< mean error
    double spread = missing;  ///< standard deviation of the error about its mean
    double bound = missing;   ///< root mean square of the bounds
    Mean normalised;          ///< mean of the squared error over the believed variance: 1 if the belief is right
    Mean first_step;          ///< mean
    Mean bias_displaced;      ///< mean error of the matches from displaced predictions
    double spread_displaced = missing;
    /// The share of a displacement that is left after the match: regression of the error on the displacement.
    double left = missing;
    /// Root mean square of the standard deviations that the matches believe; of all matches, so that it shows what is
    /// believed of an axis that no scan holds.
    double believed = missing;

    static constexpr std::size_t least_held = 30;
};

struct Summary {
    std::size_t matches = 0;
    std::size_t lost = 0;  ///< matches that were rejected or ended far off the truth; they are in no other figure
    std::array<AxisSummary, axis_count> axes;
    Mean drift;  ///< share of the way
};

/// A scan holds an axis if the bound is below a tenth of the distance (or turn) between scans that enter the map: it
/// could then place the scan in the map. A match is lost if it is farther off the truth than this distance along such
/// an axis.
/// \param trials of each layout of a world; \param drifts of each layout
Summary summarise(const std::vector<std::vector<Trial>>& trials, const std::vector<double>& drifts,
                  const RbpfSettings& filter);

}  // namespace ddtool::matcher_bench

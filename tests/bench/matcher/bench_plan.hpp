#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "sim/lidar.hpp"
#include "trial_summary.hpp"

namespace ddtool::matcher_bench {

/// The lidar of the bench where nothing else is said.
inline const sim::LidarSettings usual_lidar{.beams = 360, .range_max_m = 12.0, .range_noise_m = 0.015};

/// What a run of the bench measures: every world with every lidar and every cell size.
struct Plan {
    std::vector<std::string> worlds;
    std::vector<sim::LidarSettings> lidars{usual_lidar};
    std::vector<double> cell_sizes_m{0.025, 0.05, 0.1};
    std::uint64_t layouts = 8;  ///< of each world
    double length_m = 100.0;    ///< of each corridor
    bool known_map = false;     ///< whether the map is there before, rather than grows at the frontier
    TrialSettings trials;       ///< the cell size in it is not used
};

struct CaseResult {
    std::string world;
    sim::LidarSettings lidar;
    double cell_size_m = 0.0;
    Summary summary;
};

/// Measures all cases, world by world. The same plan gives the same results.
/// \param done is called after each case
std::vector<CaseResult> run_plan(const Plan& plan, const std::function<void(const CaseResult&)>& done);

}  // namespace ddtool::matcher_bench

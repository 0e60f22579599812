#pragma once

#include "check/odometry_witness.hpp"
#include "check/open_stretches.hpp"
#include "check/scan_pairs.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool::check {

/// All that the self-check of a run measured.
struct Evidence {
    std::size_t scans = 0;  ///< that were kept and compared
    PairEvidence neighbours, revisits;
    PairEvidence odometry_neighbours, odometry_revisits;  ///< the same scans placed by the odometry alone
    OdometryEvidence odometry;
    OpenStretches open;
};

Json to_json_object(const Evidence& evidence);

}  // namespace ddtool::check

#pragma once

#include <span>

#include "dataset/labels.hpp"
#include "dataset/sample_record.hpp"
#include "ddtool/filter/rbpf.hpp"

namespace ddtool::dataset {

/// Fills in everything of a record that follows from the snapshot and the scan's information: dispersions, physical
/// bounds and both labels. The filter's settings say how sure odometry and map are. Without information the bounds are
/// NaN and the label `fisher` is unknown.
void set_labels(SampleRecord& record, std::span<const SnapshotParticle> particles, const RbpfSettings& filter,
                const LabelSettings& rules);

}  // namespace ddtool::dataset

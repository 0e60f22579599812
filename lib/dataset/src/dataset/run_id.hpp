#pragma once

#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

/// What the id of a run is the fingerprint of: its configuration in the form that it had when data sets were first
/// published. The id decides which of the run's snapshots are kept, so that a data set built again comes out the same
/// only while this text is the same: settings that have become constants still stand in it, and those that change no
/// snapshot do not.
Json identity_of(Json configuration);

}  // namespace ddtool::dataset

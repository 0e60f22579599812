#pragma once

#include "ddtool/system/settings.hpp"

namespace ddtool::dataset {

/// The text whose fingerprint is the id of a run: its configuration in the form that it had when data sets were first
/// published. The id decides which snapshots of the run are kept, so a data set that is built again is the same only as
/// long as this text does not change. Therefore it still contains settings that have become constants, and it does not
/// contain settings that change no snapshot.
Json identity_of(Json configuration);

/// The same for the settings of a simulation alone.
Json identity_of_simulation(Json simulation);

}  // namespace ddtool::dataset

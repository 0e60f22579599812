#pragma once

#include <cstdint>
#include <vector>

#include "dataset/labels.hpp"
#include "system/setting_rows.hpp"

namespace ddtool::dataset {

/// How the snapshots of a run are thinned. Neighbouring snapshots are almost copies of each other, so only some are
/// kept.
struct ThinningSettings {
    std::uint64_t every = 3;          ///< one of this many consecutive snapshots is kept, chosen at random
    std::uint64_t most_per_run = 80;  ///< if more are left, this many of them are kept, chosen at random
};

/// How many samples of each class are wanted; the defaults are the paper's.
struct BalanceSettings {
    std::uint64_t degenerate = 3937;
    std::uint64_t not_degenerate = 3827;
};

/// The settings by which finished runs are assembled to a data set.
struct AssemblySettings {
    std::uint64_t seed = 1;  ///< of the choice of samples
    LabelSettings labels;
    BalanceSettings balance;
    std::uint64_t shard_megabytes = 64;  ///< a shard is closed when its particles reach it
};

/// The description of every setting of a build, in the order of the settings in JSON.
std::vector<Setting> build_setting_list();

/// Every setting of a build with its default: the keys a configuration may have. docs/dataset.md explains them.
Json default_build_json();

/// Throws UsageError naming the key for a value that makes no sense.
AssemblySettings assembly_from_json(const Json& settings);
ThinningSettings thinning_from_json(const Json& thinning);

/// The settings by which the runs themselves are made, except those of their items. Throws UsageError naming the key.
void expect_valid_plan(const Json& settings);

}  // namespace ddtool::dataset

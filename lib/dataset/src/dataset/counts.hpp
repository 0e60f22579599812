#pragma once

#include <span>
#include <string>
#include <vector>

#include "dataset/build_settings.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// The manifest's `counts`: by rule what was wanted, the candidates, and the chosen in the parts of each split.
Json counts_of(std::span<const SampleRecord> candidates, const BalanceSettings& wanted);

/// Throws Json::exception for counts that counts_of() cannot have given.
void expect_counts(const Json& counts);

/// What the data set lacks, a line each: too few samples of a class, a part of a split without one.
std::vector<std::string> shortages_in(const Json& counts);

}  // namespace ddtool::dataset

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "dataset/build_settings.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// The number of samples to take from each run, if `wanted` samples are taken as evenly as possible: all samples of a
/// run that has too few, and from the other runs numbers that differ by at most one.
std::vector<std::size_t> even_quotas(const std::vector<std::size_t>& available, std::size_t wanted);

/// A random number for every sample, which depends on the seed, the run's key (a fingerprint of its id) and the update,
/// but not on what else is in the data set.
class SampleChance {
public:
    SampleChance(std::uint64_t seed, std::vector<std::uint64_t> run_keys)
        : seed_(seed), run_keys_(std::move(run_keys)) {}
    [[nodiscard]] std::uint64_t draw(std::uint64_t purpose, const SampleRecord& record) const;
    [[nodiscard]] std::size_t runs() const { return run_keys_.size(); }

private:
    std::uint64_t seed_;
    std::vector<std::uint64_t> run_keys_;
};

/// Chooses for each label rule as many samples of each class as wanted, evenly over the runs, and parts them for the
/// split `paper`: at random, 6:2:2 of each class. Sets part[rule][paper] of all records.
void choose_samples(std::span<SampleRecord> records, const BalanceSettings& wanted, const SampleChance& chance);

}  // namespace ddtool::dataset

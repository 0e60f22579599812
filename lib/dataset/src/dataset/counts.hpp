#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "dataset/build_settings.hpp"
#include "dataset/sample_record.hpp"

namespace ddtool::dataset {

/// The number of samples of both classes.
struct ClassCounts {
    std::uint64_t degenerate = 0;
    std::uint64_t not_degenerate = 0;
};

/// The counts of one label rule.
struct RuleCounts {
    ClassCounts wanted;
    ClassCounts candidates;
    std::array<std::array<ClassCounts, 3>, 2> chosen;  ///< by Split, then train, validation, test

    [[nodiscard]] const ClassCounts& of(Split split, Part part) const { return chosen[index_of(split)][place(part)]; }
    [[nodiscard]] ClassCounts& of(Split split, Part part) { return chosen[index_of(split)][place(part)]; }

private:
    static std::size_t place(Part part) { return index_of(part) - index_of(Part::train); }
};

/// The number of samples of a data set, by label and part.
struct Counts {
    std::array<RuleCounts, 2> by_rule;  ///< by LabelRule

    [[nodiscard]] const RuleCounts& of(LabelRule rule) const { return by_rule[index_of(rule)]; }
    [[nodiscard]] RuleCounts& of(LabelRule rule) { return by_rule[index_of(rule)]; }
};

/// The manifest's `counts`: for each rule the wanted numbers, the candidates, and the chosen samples in the parts of
/// each split.
void to_json(Json& json, const Counts& counts);
void from_json(const Json& json, Counts& counts);

Counts counts_of(std::span<const SampleRecord> candidates, const BalanceSettings& wanted);

/// What the data set lacks, one line for each shortage: too few samples of a class, or a part of a split without
/// samples of a class.
std::vector<std::string> shortages_in(const Counts& counts);

}  // namespace ddtool::dataset

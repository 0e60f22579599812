#pragma once

#include <cstddef>
#include <string>

#include "study/ablation/plan.hpp"

namespace ddtool::ablation {

/// The plan at a size that so many cores can train without a GPU: each row is trained for at most one epoch per core,
/// so that the time hardly depends on the number of cores, with one seed, or with more where the cores suffice for more
/// than all epochs. It keeps every row, but no timing on a device other than the CPU.
Plan reduced_plan(Plan plan, std::size_t cores);

/// Tells in words what the reduced plan has less than the whole one, such as "1 of 3 seeds, 2 of 30 epochs".
std::string reductions(const Plan& whole, const Plan& reduced);

}  // namespace ddtool::ablation

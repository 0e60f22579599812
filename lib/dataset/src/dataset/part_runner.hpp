#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dataset/part_store.hpp"
#include "dataset/run_plan.hpp"
#include "ddtool/base/thread_pool.hpp"

namespace ddtool::dataset {

/// What became of a planned run.
struct RunResult {
    std::optional<StoredPart> part;
    std::string failure;  ///< why there is no part
};

/// Part `index` of `count`, for machines that share the work: every count-th run.
struct WorkShare {
    std::size_t index = 1;
    std::size_t count = 1;

    [[nodiscard]] bool has(std::size_t run) const { return run % count == index - 1; }
};
/// From "3/8", the third of eight. Throws UsageError.
WorkShare parse_work_share(const std::string& text);

/// Gives every run of the share a result: from the store where it is there, else by making it. Runs are made in
/// parallel, each on one thread; one that fails does not stop the others and is tried again next time. `program` names
/// the build that computes. Runs outside of the share have neither part nor failure.
std::vector<RunResult> make_parts(const RunPlan& plan, const WorkShare& share, PartStore& store, ThreadPool& threads,
                                  const std::string& program);

/// All runs from the store; throws Error naming how many are missing and the first.
std::vector<RunResult> find_parts(const RunPlan& plan, const PartStore& store);

}  // namespace ddtool::dataset

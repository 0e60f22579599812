#pragma once

#include <string>
#include <vector>

#include "check/evidence.hpp"

namespace ddtool::check {

/// What the self-check says of a run's result.
enum class Standing {
    plausible,  ///< nothing contradicts it
    doubtful,   ///< some of the numbers do not fit each other, so that the map may be wrong
    refuted     ///< the scans contradict each other where the map puts them, so that the map is wrong
};
std::string name_of(Standing standing);

struct Verdict {
    Standing standing = Standing::plausible;
    std::vector<std::string> reasons;  ///< one sentence each, with numbers; empty if the result is plausible
};

Verdict verdict_of(const Evidence& evidence);

/// The verdict and the evidence in the form of run.json (docs/formats/results.md).
Json self_check_json(const Verdict& verdict, const Evidence& evidence);

}  // namespace ddtool::check

#include "study/ablation/reduced_plan.hpp"

#include <algorithm>

#include "ddtool/system/settings.hpp"

namespace ddtool::ablation {
namespace {

std::size_t most_epochs(const Plan& plan) {
    std::size_t most = 0;
    for (const Row& row : plan.rows) {
        most = std::max(most, row.settings.epochs);
    }
    return most;
}

std::string part(std::size_t kept, std::size_t all, const std::string& unit) {
    return std::to_string(kept) + " of " + std::to_string(all) + " " + unit;
}

}  // namespace

Plan reduced_plan(Plan plan, std::size_t cores) {
    const std::size_t seeds = std::clamp<std::size_t>(cores / most_epochs(plan), 1, plan.seeds.size());
    plan.seeds.resize(seeds);
    for (Row& row : plan.rows) {
        row.settings.epochs = std::min(row.settings.epochs, cores);
    }
    std::erase_if(plan.timings, [](const Timing& timing) { return timing.device != "cpu"; });
    return plan;
}

std::string reductions(const Plan& whole, const Plan& reduced) {
    std::vector<std::string> parts;
    const auto add = [&](std::size_t kept, std::size_t all, const std::string& unit) {
        if (kept < all) {
            parts.push_back(part(kept, all, unit));
        }
    };
    add(reduced.seeds.size(), whole.seeds.size(), "seeds");
    add(most_epochs(reduced), most_epochs(whole), "epochs");
    add(reduced.timings.size(), whole.timings.size(), "timings");
    return parts.empty() ? "nothing is left out" : joined(parts);
}

}  // namespace ddtool::ablation

#include "trial_summary.hpp"

#include <algorithm>
#include <cmath>

#include "base/squared.hpp"

namespace ddtool::matcher_bench {
namespace {

/// Matches so far apart share hardly any piece of the map.
constexpr double block_m = 5.0;
constexpr std::uint64_t most_blocks_per_layout = 1'000'000;
constexpr double held_share = 0.1;

struct Limits {
    explicit Limits(const RbpfSettings& filter)
        : lost(filter.insert_distance_m, filter.insert_distance_m, filter.insert_turn_rad) {}

    [[nodiscard]] bool holds(const Trial& trial, Eigen::Index axis) const {
        return trial.bound[axis] < held_share * lost[axis];
    }
    [[nodiscard]] bool is_lost(const Trial& trial) const {
        for (Eigen::Index axis = 0; axis < lost.size(); ++axis) {
            const double worst = std::max(std::abs(trial.error[axis]), std::abs(trial.error_displaced[axis]));
            if (holds(trial, axis) && worst > lost[axis]) {
                return true;
            }
        }
        return !trial.accepted;
    }

    Eigen::Vector3d lost;
};

/// Mean, and standard deviation about it.
struct Errors {
    BlockMean mean;
    double squares = 0.0;

    void add(std::uint64_t block, double error) {
        mean.add(block, error);
        squares += squared(error);
    }
    [[nodiscard]] double spread() const {
        const auto count = static_cast<double>(mean.count());
        return std::sqrt(std::max(0.0, squares - count * squared(mean.mean().value)) / (count - 1.0));
    }
};

class AxisSums {
public:
    void add(std::uint64_t block, const Trial& trial, Eigen::Index axis, bool held) {
        believed_.add(block, squared(trial.believed[axis]));
        if (!held) {
            return;
        }
        errors_.add(block, trial.error[axis]);
        errors_displaced_.add(block, trial.error_displaced[axis]);
        bound_.add(block, squared(trial.bound[axis]));
        normalised_.add(block, squared(trial.error[axis] / trial.believed[axis]));
        first_step_.add(block, trial.first_step[axis]);
        displacement_squares_ += squared(trial.displacement[axis]);
        displacement_products_ += trial.displacement[axis] * trial.error_displaced[axis];
    }

    [[nodiscard]] AxisSummary summary() const {
        AxisSummary result;
        result.held = bound_.count();
        result.believed = std::sqrt(believed_.mean().value);
        if (result.held < AxisSummary::least_held) {
            return result;
        }
        result.bias = errors_.mean.mean();
        result.spread = errors_.spread();
        result.bound = std::sqrt(bound_.mean().value);
        result.normalised = normalised_.mean();
        result.first_step = first_step_.mean();
        result.bias_displaced = errors_displaced_.mean.mean();
        result.spread_displaced = errors_displaced_.spread();
        result.left = displacement_products_ / displacement_squares_;
        return result;
    }

private:
    Errors errors_;
    Errors errors_displaced_;
    BlockMean bound_, normalised_, first_step_, believed_;
    double displacement_squares_ = 0.0;
    double displacement_products_ = 0.0;
};

}  // namespace

void BlockMean::add(std::uint64_t block, double value) {
    Sum& sum = blocks_[block];
    sum.values += value;
    sum.count += 1.0;
    ++count_;
}

Mean BlockMean::mean() const {
    if (blocks_.empty()) {
        return {};
    }
    const auto count = static_cast<double>(count_);
    double total = 0.0;
    for (const auto& [block, sum] : blocks_) {
        total += sum.values;
    }
    Mean result{.value = total / count, .standard_error = missing};
    if (blocks_.size() > 1) {
        double squares = 0.0;
        for (const auto& [block, sum] : blocks_) {
            squares += squared(sum.values - sum.count * result.value);
        }
        const auto blocks = static_cast<double>(blocks_.size());
        result.standard_error = std::sqrt(squares * blocks / (blocks - 1.0)) / count;
    }
    return result;
}

Summary summarise(const std::vector<std::vector<Trial>>& trials, const std::vector<double>& drifts,
                  const RbpfSettings& filter) {
    const Limits limits(filter);
    std::array<AxisSums, axis_count> sums;
    Summary result;
    for (std::size_t layout = 0; layout < trials.size(); ++layout) {
        for (const Trial& trial : trials[layout]) {
            ++result.matches;
            if (limits.is_lost(trial)) {
                ++result.lost;
                continue;
            }
            const std::uint64_t block =
                layout * most_blocks_per_layout + static_cast<std::uint64_t>(trial.way_m / block_m);
            for (std::size_t axis = 0; axis < axis_count; ++axis) {
                const auto index = static_cast<Eigen::Index>(axis);
                sums[axis].add(block, trial, index, limits.holds(trial, index));
            }
        }
    }
    for (std::size_t axis = 0; axis < axis_count; ++axis) {
        result.axes[axis] = sums[axis].summary();
    }
    BlockMean drift;
    for (std::size_t layout = 0; layout < drifts.size(); ++layout) {
        drift.add(layout, drifts[layout]);
    }
    result.drift = drift.mean();
    return result;
}

}  // namespace ddtool::matcher_bench

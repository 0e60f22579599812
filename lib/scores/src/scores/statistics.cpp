#include "scores/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "scores/rank_statistics.hpp"

namespace ddtool {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

std::vector<double> sorted(std::span<const double> values) {
    std::vector<double> copy(values.begin(), values.end());
    std::sort(copy.begin(), copy.end());
    return copy;
}

/// The probability that B <= k, where B has the binomial distribution of n trials with probability 1/2.
double binomial_half_cdf(std::size_t k, std::size_t n) {
    double log_choose = 0.0;
    double sum = 0.0;
    for (std::size_t i = 0; i <= k; ++i) {
        sum += std::exp(log_choose - static_cast<double>(n) * std::log(2.0));
        log_choose += std::log(static_cast<double>(n - i)) - std::log(static_cast<double>(i + 1));
    }
    return sum;
}

std::vector<double> differences(std::span<const double> first, std::span<const double> second) {
    std::vector<double> result;
    for (std::size_t i = 0; i < first.size(); ++i) {
        result.push_back(first[i] == second[i] ? 0.0 : second[i] - first[i]);
    }
    return result;
}

/// The probability of every possible rank sum, if each rank is included with probability 1/2.
std::vector<double> rank_sum_distribution(const std::vector<std::size_t>& ranks) {
    std::vector<double> probability(std::accumulate(ranks.begin(), ranks.end(), std::size_t{1}), 0.0);
    probability[0] = 1.0;
    for (const std::size_t rank : ranks) {
        for (std::size_t sum = probability.size(); sum-- > 0;) {
            probability[sum] = 0.5 * (probability[sum] + (sum >= rank ? probability[sum - rank] : 0.0));
        }
    }
    return probability;
}

double two_sided_p(const std::vector<double>& nonzero_differences) {
    std::vector<double> magnitudes;
    magnitudes.reserve(nonzero_differences.size());
    for (const double difference : nonzero_differences) {
        magnitudes.push_back(std::abs(difference));
    }
    const std::vector<std::size_t> ranks = doubled_ranks(magnitudes);
    std::size_t positive_sum = 0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        positive_sum += nonzero_differences[i] > 0.0 ? ranks[i] : 0;
    }
    const std::vector<double> probability = rank_sum_distribution(ranks);
    // The distribution is symmetric, so the smaller of the two tails belongs to the smaller rank sum.
    const std::size_t smaller_sum = std::min(positive_sum, probability.size() - 1 - positive_sum);
    const auto end = probability.begin() + static_cast<std::ptrdiff_t>(smaller_sum) + 1;
    return std::min(1.0, 2.0 * std::accumulate(probability.begin(), end, 0.0));
}

}  // namespace

double quantile(std::span<const double> values, double fraction) {
    if (values.empty()) {
        return not_a_number;
    }
    const std::vector<double> order = sorted(values);
    const double place = fraction * static_cast<double>(order.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const double share = place - static_cast<double>(below);
    if (share == 0.0 || order[below] == order[below + 1]) {  // interpolating between two infinite values would give NaN
        return order[below];
    }
    return order[below] + share * (order[below + 1] - order[below]);
}

double median(std::span<const double> values) { return quantile(values, 0.5); }

MeanAndSd mean_and_sd(std::span<const double> values) {
    const auto count = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
    const double squares = std::accumulate(values.begin(), values.end(), 0.0, [&](double sum, double value) {
        return sum + (value - mean) * (value - mean);
    });
    return {mean, values.size() < 2 ? not_a_number : std::sqrt(squares / (count - 1.0))};
}

MedianInterval median_interval(std::span<const double> values, double wanted_coverage) {
    if (values.empty()) {
        return {not_a_number, not_a_number, 0.0};
    }
    const std::vector<double> order = sorted(values);
    const auto coverage_without = [&](std::size_t left_out) {
        return 1.0 - 2.0 * binomial_half_cdf(left_out, order.size());
    };
    std::size_t left_out = 0;  // number of values that are left out at each end
    while (2 * (left_out + 1) < order.size() && coverage_without(left_out + 1) >= wanted_coverage) {
        ++left_out;
    }
    return {order[left_out], order[order.size() - 1 - left_out], std::max(0.0, coverage_without(left_out))};
}

PairedTest wilcoxon_signed_rank(std::span<const double> first, std::span<const double> second) {
    const std::vector<double> all = differences(first, second);
    PairedTest test;
    test.median_difference = median(all);
    std::vector<double> nonzero = all;
    std::erase(nonzero, 0.0);
    test.differing_pairs = nonzero.size();
    test.p_value = two_sided_p(nonzero);
    return test;
}

}  // namespace ddtool

#include "scores/rank_statistics.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <map>

namespace ddtool {

std::vector<std::size_t> doubled_ranks(std::span<const double> values) {
    std::vector<double> order(values.begin(), values.end());
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> ranks;
    ranks.reserve(values.size());
    for (const double value : values) {
        const auto [first, last] = std::equal_range(order.begin(), order.end(), value);
        ranks.push_back(static_cast<std::size_t>((first - order.begin()) + (last - order.begin()) + 1));
    }
    return ranks;
}

double roc_auc(std::span<const double> scores, const std::vector<bool>& positive) {
    std::vector<double> known;
    std::vector<bool> known_positive;
    for (std::size_t i = 0; i < scores.size(); ++i) {
        if (!std::isnan(scores[i])) {
            known.push_back(scores[i]);
            known_positive.push_back(positive[i]);
        }
    }
    const std::vector<std::size_t> ranks = doubled_ranks(known);
    double positives = 0.0;
    double rank_sum = 0.0;
    for (std::size_t i = 0; i < ranks.size(); ++i) {
        if (known_positive[i]) {
            positives += 1.0;
            rank_sum += 0.5 * static_cast<double>(ranks[i]);
        }
    }
    const double negatives = static_cast<double>(ranks.size()) - positives;
    if (positives == 0.0 || negatives == 0.0) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return (rank_sum - 0.5 * positives * (positives + 1.0)) / (positives * negatives);
}

std::vector<RocPoint> roc_curve(std::span<const double> scores, const std::vector<bool>& positive) {
    // number of negatives and of positives for each score
    std::map<double, std::array<double, 2>, std::greater<>> counts;
    std::array<double, 2> all{};
    for (std::size_t i = 0; i < scores.size(); ++i) {
        const std::size_t side = positive[i] ? 1 : 0;
        counts[scores[i]][side] += 1.0;
        all[side] += 1.0;
    }
    if (all[0] == 0.0 || all[1] == 0.0) {
        return {};
    }
    std::vector<RocPoint> points{{}};
    std::array<double, 2> above{};
    for (const auto& [score, at] : counts) {
        above[0] += at[0];
        above[1] += at[1];
        points.push_back({above[0] / all[0], above[1] / all[1]});
    }
    return points;
}

double rank_correlation(std::span<const double> first, std::span<const double> second) {
    std::vector<double> first_known;
    std::vector<double> second_known;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (!std::isnan(first[i]) && !std::isnan(second[i])) {
            first_known.push_back(first[i]);
            second_known.push_back(second[i]);
        }
    }
    const std::vector<std::size_t> first_ranks = doubled_ranks(first_known);
    const std::vector<std::size_t> second_ranks = doubled_ranks(second_known);
    const double mean = static_cast<double>(first_ranks.size()) + 1.0;  // the mean of the doubled ranks 2, 4, ..., 2n
    double covariance = 0.0;
    double first_variance = 0.0;
    double second_variance = 0.0;
    for (std::size_t i = 0; i < first_ranks.size(); ++i) {
        const double a = static_cast<double>(first_ranks[i]) - mean;
        const double b = static_cast<double>(second_ranks[i]) - mean;
        covariance += a * b;
        first_variance += a * a;
        second_variance += b * b;
    }
    if (first_variance == 0.0 || second_variance == 0.0) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    return covariance / std::sqrt(first_variance * second_variance);
}

}  // namespace ddtool

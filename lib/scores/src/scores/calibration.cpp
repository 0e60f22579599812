#include "scores/calibration.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ddtool {
namespace {

constexpr double least_probability = 1e-9;
constexpr double most_temperature = 100.0;

double logit(double probability) {
    const double inside = std::clamp(probability, least_probability, 1.0 - least_probability);
    return std::log(inside / (1.0 - inside));
}

double logistic(double value) { return 1.0 / (1.0 + std::exp(-value)); }

std::size_t bin_of(double probability, std::size_t bins) {
    const double place = std::ceil(probability * static_cast<double>(bins)) - 1.0;
    return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(bins - 1)));
}

/// The derivative of the negative log-likelihood by 1/temperature. It never falls, so its root can be found by
/// bisection.
double slope(std::span<const double> logits, const std::vector<bool>& positive, double inverse_temperature) {
    double sum = 0.0;
    for (std::size_t index = 0; index < logits.size(); ++index) {
        sum += (logistic(inverse_temperature * logits[index]) - (positive[index] ? 1.0 : 0.0)) * logits[index];
    }
    return sum;
}

}  // namespace

std::vector<ReliabilityBin> reliability(std::span<const double> probabilities, const std::vector<bool>& positive,
                                        std::size_t bins) {
    std::vector<ReliabilityBin> filled(bins);
    for (std::size_t bin = 0; bin < bins; ++bin) {
        filled[bin].low = static_cast<double>(bin) / static_cast<double>(bins);
        filled[bin].high = static_cast<double>(bin + 1) / static_cast<double>(bins);
    }
    for (std::size_t index = 0; index < probabilities.size(); ++index) {
        ReliabilityBin& bin = filled[bin_of(probabilities[index], bins)];
        ++bin.count;
        bin.mean_probability += probabilities[index];
        bin.positive_share += positive[index] ? 1.0 : 0.0;
    }
    for (ReliabilityBin& bin : filled) {
        bin.mean_probability /= static_cast<double>(bin.count);
        bin.positive_share /= static_cast<double>(bin.count);
    }
    return filled;
}

double expected_calibration_error(std::span<const ReliabilityBin> bins) {
    double gaps = 0.0;
    double count = 0.0;
    for (const ReliabilityBin& bin : bins) {
        if (bin.count > 0) {
            gaps += static_cast<double>(bin.count) * std::abs(bin.positive_share - bin.mean_probability);
            count += static_cast<double>(bin.count);
        }
    }
    return gaps / count;
}

double at_temperature(double probability, double temperature) { return logistic(logit(probability) / temperature); }

double fitted_temperature(std::span<const double> probabilities, const std::vector<bool>& positive) {
    if (probabilities.empty()) {
        return 1.0;
    }
    std::vector<double> logits(probabilities.size());
    std::transform(probabilities.begin(), probabilities.end(), logits.begin(), logit);
    double low = 1.0 / most_temperature;
    double high = most_temperature;
    while (high / low > 1.0 + 1e-12) {
        const double middle = std::sqrt(low * high);
        (slope(logits, positive, middle) > 0.0 ? high : low) = middle;
    }
    return 1.0 / std::sqrt(low * high);
}

}  // namespace ddtool

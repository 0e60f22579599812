#include "scores/confusion.hpp"

#include <limits>

namespace ddtool {
namespace {

double share(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? std::numeric_limits<double>::quiet_NaN()
                      : static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

void Confusion::add(bool decided, bool positive) {
    if (decided) {
        ++(positive ? true_positives : false_positives);
    } else {
        ++(positive ? false_negatives : true_negatives);
    }
}

std::uint64_t Confusion::count() const { return true_positives + false_positives + false_negatives + true_negatives; }

double Confusion::accuracy() const { return share(true_positives + true_negatives, count()); }

double Confusion::precision() const { return share(true_positives, true_positives + false_positives); }

double Confusion::recall() const { return share(true_positives, true_positives + false_negatives); }

double Confusion::f1() const {
    return share(2 * true_positives, 2 * true_positives + false_positives + false_negatives);
}

Confusion confusion_of(std::span<const double> scores, const std::vector<bool>& positive, double threshold) {
    Confusion confusion;
    for (std::size_t index = 0; index < scores.size(); ++index) {
        confusion.add(scores[index] > threshold, positive[index]);
    }
    return confusion;
}

}  // namespace ddtool

#pragma once

#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"

namespace ddtool::judge {

/// How well scores agree with the physical information of the scan, over the samples of one kind of source.
struct PhysicalAgreement {
    std::string source;  ///< world or log
    std::size_t samples = 0;
    double auc = 0.0;          ///< for the label `fisher`; NaN for logs, which have none
    double weak_sd_rho = 0.0;  ///< rank correlation with weak_sd_m, what the scan leaves open: positive is good
    /// Rank correlation with the smaller eigenvalue of the scan's information about the position, heading known:
    /// negative is good.
    double information_rho = 0.0;
};

/// Returns one entry for each kind of source that has samples with a known weak_sd_m. `scores` has one score for each
/// of `samples`.
std::vector<PhysicalAgreement> physical_agreement(const dataset::Dataset& data, std::span<const std::size_t> samples,
                                                  std::span<const double> scores);

}  // namespace ddtool::judge

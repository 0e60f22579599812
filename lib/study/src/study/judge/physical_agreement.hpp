#pragma once

#include <span>
#include <string>
#include <vector>

#include "dataset/dataset.hpp"

namespace ddtool::judge {

/// How scores follow what the scan physically tells, over the samples of one kind of source.
struct PhysicalAgreement {
    std::string source;  ///< world or log
    std::size_t samples = 0;
    double auc = 0.0;          ///< for the label `fisher`; NaN for logs, which have none
    double weak_sd_rho = 0.0;  ///< rank correlation with weak_sd_m, what the scan leaves open: positive is good
    /// Rank correlation with the smaller eigenvalue of the scan's information about the position, heading known:
    /// negative is good.
    double information_rho = 0.0;
};

/// An entry for each kind of source with samples whose weak_sd_m is known. Both lists have the same length.
std::vector<PhysicalAgreement> physical_agreement(const dataset::Dataset& data, std::span<const std::size_t> samples,
                                                  std::span<const double> scores);

}  // namespace ddtool::judge

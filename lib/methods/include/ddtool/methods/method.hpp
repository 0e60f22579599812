#pragma once

#include <memory>
#include <string>
#include <vector>

#include "ddtool/filter/coarse_fine_search.hpp"
#include "ddtool/filter/correlative_search.hpp"
#include "ddtool/filter/enhanced_resampling.hpp"
#include "ddtool/filter/information_fusion.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/odometry_trust.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "ddtool/methods/detector_table.hpp"

namespace ddtool {

/// A method of the filter: the name of its part in each place where methods differ.
struct MethodParts {
    std::string detector = "none";
    std::string gate{};                     ///< when the detector is asked: in-doubt, none; empty: its usual_gate()
    std::string search = "none";            ///< a second search for the match: coarse-fine, correlative
    std::string trust = "none";             ///< match or odometry: lidar-score, information, eigenvalue-gate, odometry
    std::string resampling = "systematic";  ///< or enhanced
    std::string odometry = "as-logged";     ///< or learnt
};

/// Which method, its parts where they differ from the method's own, and the settings of all parts.
struct MethodSettings {
    std::string method = "anti-degeneracy";
    MethodParts parts{"", "", "", "", "", ""};  ///< empty: as the method has it
    DetectionSettings detection;
    CoarseFineSettings coarse_fine;
    CorrelativeSearchSettings correlative;
    FusionSettings fusion;
    EigenvalueGateSettings eigenvalue_gate;
    EnhancedResamplingSettings enhanced_resampling;
};

/// Everything that makes a filter.
struct FilterSettings {
    RbpfSettings rbpf;
    MethodSettings method;
};

/// The names of all methods.
std::vector<std::string> method_names();

/// The names of the parts in each place, but for the detectors', which their table has.
std::vector<std::string> search_names();
std::vector<std::string> trust_names();
std::vector<std::string> resampling_names();
std::vector<std::string> odometry_names();

/// The parts in effect, all of them named: the method's, except where the settings name others. Throws UsageError for
/// an unknown method.
MethodParts parts_of(const MethodSettings& settings);

/// The filter of a method; one with a single hypothesis has one particle, whatever the settings say. Its maps may take
/// three quarters of the memory that the machine has free, where the settings set no limit. Throws UsageError
/// for an unknown name and Error for a detector that cannot be made.
std::unique_ptr<Rbpf> make_filter(const FilterSettings& settings, const DetectorTable& detectors, ThreadPool& threads);

}  // namespace ddtool

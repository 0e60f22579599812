#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/filter/coarse_fine_search.hpp"
#include "ddtool/filter/correlative_search.hpp"
#include "ddtool/filter/enhanced_resampling.hpp"
#include "ddtool/filter/gmapping_filter.hpp"
#include "ddtool/filter/information_fusion.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "ddtool/filter/odometry_trust.hpp"
#include "ddtool/filter/rbpf.hpp"
#include "ddtool/methods/detector_table.hpp"

namespace ddtool {

/// A method of the filter: for each place where methods differ, the name of the part that it uses.
struct MethodParts {
    std::string detector = "none";
    std::string gate{};           ///< when the detector runs: in-doubt, none; empty: DetectorTable::usual_gate()
    std::string search = "none";  ///< a second search for the match: coarse-fine, correlative
    std::string trust = "none";   ///< match or odometry: lidar-score, information, eigenvalue-gate, odometry
    std::string resampling = "systematic";  ///< or enhanced
    std::string odometry = "as-logged";     ///< or learnt
};

/// Which method to use, the parts that differ from the method's own, and the settings of all parts.
struct MethodSettings {
    std::string method = "anti-degeneracy";
    MethodParts parts{"", "", "", "", "", ""};  ///< an empty name keeps the method's own part
    DetectionSettings detection;
    CoarseFineSettings coarse_fine;
    CorrelativeSearchSettings correlative;
    FusionSettings fusion;
    EigenvalueGateSettings eigenvalue_gate;
    EnhancedResamplingSettings enhanced_resampling;
    /// of the parts coarse-fine and lidar-score in a GmappingFilter; which of its strategies act follows from the parts
    FailedMatchSettings failed_match;
};

/// All settings of a filter. The number of particles, the seed, the grid and the scan points of `rbpf` hold for the
/// GmappingFilter, too.
struct FilterSettings {
    RbpfSettings rbpf;
    GmappingSettings gmapping;
    MethodSettings method;
};

/// The names of all methods.
std::vector<std::string> method_names();

/// The names of the parts for each place, except for the detectors, whose names DetectorTable has.
std::vector<std::string> search_names();
std::vector<std::string> trust_names();
std::vector<std::string> resampling_names();
std::vector<std::string> odometry_names();

/// The parts that are used, all of them named: those of the method, except where the settings name others. Throws
/// UsageError for an unknown method.
MethodParts parts_of(const MethodSettings& settings);

/// Whether the method's filter is a GmappingFilter. Throws UsageError for an unknown method.
bool runs_gmapping(const std::string& method);

/// The motion of the odometry that makes the filter of these settings update.
struct UpdateMotion {
    double distance_m = 0.0;
    double turn_rad = 0.0;
};
UpdateMotion update_motion(const FilterSettings& settings);

/// The parts of the method of an Rbpf, made. Throws UsageError for an unknown name and for a method whose filter is a
/// GmappingFilter, and Error for a detector that cannot be made.
FilterStrategies make_strategies(const FilterSettings& settings, const DetectorTable& detectors);

/// The limit in MiB on the memory of all maps of the process where the settings set none: three quarters of what was
/// free on the machine when this was first called.
std::uint64_t usual_most_memory_mib();

/// Makes the filter of a method: a GmappingFilter for "gmapping" and "paper", an Rbpf for all others. A method with a
/// single hypothesis gets one particle, whatever the settings say. If the settings set no memory limit, the maps may
/// take three quarters of the memory that was free on the machine when the process made its first filter with this
/// default. `threads` must outlive the filter. Throws UsageError for an unknown name and for a part that the method
/// cannot have, and Error for a detector that cannot be made.
std::unique_ptr<ParticleFilter> make_filter(const FilterSettings& settings, const DetectorTable& detectors,
                                            ThreadPool& threads);

}  // namespace ddtool

#include "ddtool/methods/method.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "ddtool/system/settings.hpp"
#include "system/process_usage.hpp"

namespace ddtool {
namespace {

enum class FilterKind { rbpf, rbpf_of_one_particle, gmapping };

struct Method {
    std::string name;
    MethodParts parts;
    FilterKind filter = FilterKind::rbpf;
};

const std::vector<Method>& methods() {
    static const std::vector<Method> table{
        {"gmapping", {}, FilterKind::gmapping},
        {"rbpf", {}},
        {"paper",
         {.detector = paper_model_name,
          .gate = "none",
          .search = "coarse-fine",
          .trust = "lidar-score",
          .resampling = "enhanced"},
         FilterKind::gmapping},
        {"paper-strategies-on-ours",
         {.detector = "covariance", .search = "coarse-fine", .trust = "lidar-score", .resampling = "enhanced"}},
        {"anti-degeneracy", {.detector = shipped_model_name, .trust = "information", .odometry = "learnt"}},
        {"fisher-gate", {.trust = "eigenvalue-gate"}},
        {"dn-csm", {.search = "correlative"}, FilterKind::rbpf_of_one_particle},
        {"odometry", {.trust = "odometry"}, FilterKind::rbpf_of_one_particle},
    };
    return table;
}

const Method& method_of(const std::string& name) {
    const auto found =
        std::find_if(methods().begin(), methods().end(), [&](const Method& method) { return method.name == name; });
    if (found == methods().end()) {
        throw UsageError("filter.method: expected " + joined(method_names()) + ", not '" + name + "'");
    }
    return *found;
}

/// The parts to choose from for one place of the filter, each with its name.
template <typename Part>
using Choices = std::vector<std::pair<std::string, Part>>;

template <typename Part>
std::vector<std::string> names_of(const Choices<Part>& choices) {
    std::vector<std::string> names;
    for (const auto& [name, part] : choices) {
        names.push_back(name);
    }
    return names;
}

template <typename Part>
Part chosen(const Choices<Part>& choices, const std::string& key, const std::string& name) {
    for (const auto& [known, part] : choices) {
        if (known == name) {
            return part;
        }
    }
    throw UsageError("filter." + key + ": expected " + joined(names_of(choices)) + ", not '" + name + "'");
}

using Correction = std::shared_ptr<const PoseCorrection>;

Choices<Correction> search_choices(const MethodSettings& settings) {
    return {{"none", nullptr},
            {"coarse-fine", std::make_shared<CoarseFineSearch>(settings.coarse_fine)},
            {"correlative", std::make_shared<CorrelativeSearch>(settings.correlative)}};
}

Choices<Correction> trust_choices(const MethodSettings& settings) {
    return {{"none", nullptr},
            {"lidar-score", std::make_shared<LidarScoreTrust>()},
            {"information", std::make_shared<InformationFusion>(settings.fusion)},
            {"eigenvalue-gate", std::make_shared<EigenvalueGate>(settings.eigenvalue_gate)},
            {"odometry", std::make_shared<OdometryTrust>()}};
}

Choices<std::shared_ptr<const Resampling>> resampling_choices(const MethodSettings& settings) {
    return {{"systematic", std::make_shared<SystematicResampling>()},
            {"enhanced", std::make_shared<EnhancedResampling>(settings.enhanced_resampling)}};
}

Choices<std::function<std::unique_ptr<OdometryModel>()>> odometry_choices(const FilterSettings& settings) {
    return {{"as-logged", [noise = settings.rbpf.motion] { return std::make_unique<FixedOdometry>(noise); }},
            {"learnt", [] { return std::make_unique<LearntOdometry>(); }}};
}

DegeneracyDetector detector_of(const FilterSettings& settings, const DetectorTable& detectors) {
    const MethodParts parts = parts_of(settings.method);
    return gated(parts.gate, detectors.make(parts.detector, settings.method.detection, settings.rbpf.motion),
                 settings.method.detection);
}

/// Throws UsageError for a part that a GmappingFilter cannot have.
void expect_parts_of_gmapping(const MethodSettings& settings) {
    const MethodParts parts = parts_of(settings);
    const auto expect = [&](const char* key, const std::string& used, const std::vector<std::string>& allowed) {
        if (std::ranges::find(allowed, used) == allowed.end()) {
            throw UsageError(std::string("filter.") + key + ": expected " + joined(allowed) + " with the method " +
                             settings.method + ", not '" + used + "'; other parts go with the method rbpf");
        }
    };
    expect("search", parts.search, {"none", "coarse-fine"});
    expect("trust", parts.trust, {"none", "lidar-score"});
    expect("resampling", parts.resampling, resampling_names());
    expect("odometry", parts.odometry, {"as-logged"});
}

GmappingStrategies gmapping_strategies_of(const FilterSettings& settings, const DetectorTable& detectors) {
    expect_parts_of_gmapping(settings.method);
    const MethodParts parts = parts_of(settings.method);
    GmappingStrategies strategies{
        .detector = detector_of(settings, detectors),
        .failed_match = std::nullopt,
        .resampling = chosen(resampling_choices(settings.method), "resampling", parts.resampling)};
    if (parts.search != "none" || parts.trust != "none") {
        strategies.failed_match = settings.method.failed_match;
        strategies.failed_match->weighs_odometry = parts.trust != "none";
        if (parts.search != "none") {
            strategies.failed_match->search = settings.method.coarse_fine;
        }
    }
    return strategies;
}

}  // namespace

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const Method& method : methods()) {
        names.push_back(method.name);
    }
    return names;
}

std::vector<std::string> search_names() { return names_of(search_choices({})); }
std::vector<std::string> trust_names() { return names_of(trust_choices({})); }
std::vector<std::string> resampling_names() { return names_of(resampling_choices({})); }
std::vector<std::string> odometry_names() { return names_of(odometry_choices({})); }

MethodParts parts_of(const MethodSettings& settings) {
    MethodParts parts = method_of(settings.method).parts;
    for (const auto part : {&MethodParts::detector, &MethodParts::gate, &MethodParts::search, &MethodParts::trust,
                            &MethodParts::resampling, &MethodParts::odometry}) {
        if (!(settings.parts.*part).empty()) {
            parts.*part = settings.parts.*part;
        }
    }
    if (parts.gate.empty()) {
        parts.gate = DetectorTable::usual_gate(parts.detector);
    }
    return parts;
}

bool runs_gmapping(const std::string& method) { return method_of(method).filter == FilterKind::gmapping; }

UpdateMotion update_motion(const FilterSettings& settings) {
    return runs_gmapping(settings.method.method)
               ? UpdateMotion{settings.gmapping.update_distance_m, settings.gmapping.update_turn_rad}
               : UpdateMotion{settings.rbpf.update_distance_m, settings.rbpf.update_turn_rad};
}

std::uint64_t usual_most_memory_mib() {
    constexpr std::uint64_t bytes_per_mib = 1U << 20U;
    static const std::uint64_t most_mib = available_memory_bytes() / 4 * 3 / bytes_per_mib;
    return most_mib;
}

FilterStrategies make_strategies(const FilterSettings& settings, const DetectorTable& detectors) {
    if (runs_gmapping(settings.method.method)) {
        throw UsageError("filter.method: the filter of GMapping, which " + settings.method.method +
                         " uses, has no parts of this kind; expected another method");
    }
    const MethodParts parts = parts_of(settings.method);
    FilterStrategies strategies{
        .detector = detector_of(settings, detectors),
        .corrections = {chosen(search_choices(settings.method), "search", parts.search),
                        chosen(trust_choices(settings.method), "trust", parts.trust)},
        .resampling = chosen(resampling_choices(settings.method), "resampling", parts.resampling),
        .odometry = chosen(odometry_choices(settings), "odometry", parts.odometry)};
    std::erase(strategies.corrections, nullptr);
    return strategies;
}

std::unique_ptr<ParticleFilter> make_filter(const FilterSettings& settings, const DetectorTable& detectors,
                                            ThreadPool& threads) {
    RbpfSettings rbpf = settings.rbpf;
    if (rbpf.grid.most_memory_mib == 0) {
        rbpf.grid.most_memory_mib = usual_most_memory_mib();
    }
    const FilterKind kind = method_of(settings.method.method).filter;
    if (kind == FilterKind::gmapping) {
        GmappingSettings gmapping = settings.gmapping;
        gmapping.particles = rbpf.particles;
        gmapping.seed = rbpf.seed;
        gmapping.grid = rbpf.grid;
        gmapping.points = rbpf.points;
        return std::make_unique<GmappingFilter>(gmapping, threads, gmapping_strategies_of(settings, detectors));
    }
    if (kind == FilterKind::rbpf_of_one_particle) {
        rbpf.particles = 1;
    }
    return std::make_unique<Rbpf>(rbpf, threads, make_strategies(settings, detectors));
}

}  // namespace ddtool

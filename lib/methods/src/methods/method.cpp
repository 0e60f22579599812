#include "ddtool/methods/method.hpp"

#include <algorithm>

#include "ddtool/base/error.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {
namespace {

struct Method {
    std::string name;
    MethodParts parts;
    bool single_hypothesis = false;
};

const std::vector<Method>& methods() {
    static const std::vector<Method> table{
        {"gmapping", {}},
        {"paper", {"covariance", "coarse-fine", "lidar-score", "enhanced", "as-logged"}},
        {"anti-degeneracy", {native::shipped_model_name, "none", "information", "systematic", "learnt"}},
        {"fisher-gate", {"none", "none", "eigenvalue-gate", "systematic", "as-logged"}},
        {"dn-csm", {"none", "correlative", "none", "systematic", "as-logged"}, true},
        {"odometry", {"none", "none", "odometry", "systematic", "as-logged"}, true},
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

/// A place's choices: a name and the part.
template <typename Part>
using Choices = std::vector<std::pair<std::string, Part>>;

template <typename Part>
Part chosen(const Choices<Part>& choices, const std::string& key, const std::string& name) {
    std::vector<std::string> names;
    for (const auto& [known, part] : choices) {
        if (known == name) {
            return part;
        }
        names.push_back(known);
    }
    throw UsageError("filter." + key + ": expected " + joined(names) + ", not '" + name + "'");
}

using Correction = std::shared_ptr<const PoseCorrection>;

Correction search_of(const std::string& name, const MethodSettings& settings) {
    return chosen<Correction>({{"none", nullptr},
                               {"coarse-fine", std::make_shared<CoarseFineSearch>(settings.coarse_fine)},
                               {"correlative", std::make_shared<CorrelativeSearch>(settings.correlative)}},
                              "search", name);
}

Correction trust_of(const std::string& name, const MethodSettings& settings) {
    return chosen<Correction>({{"none", nullptr},
                               {"lidar-score", std::make_shared<LidarScoreTrust>()},
                               {"information", std::make_shared<InformationFusion>(settings.fusion)},
                               {"eigenvalue-gate", std::make_shared<EigenvalueGate>(settings.eigenvalue_gate)},
                               {"odometry", std::make_shared<OdometryTrust>()}},
                              "trust", name);
}

std::shared_ptr<const Resampling> resampling_of(const std::string& name, const MethodSettings& settings) {
    return chosen<std::shared_ptr<const Resampling>>(
        {{"systematic", std::make_shared<SystematicResampling>()},
         {"enhanced", std::make_shared<EnhancedResampling>(settings.enhanced_resampling)}},
        "resampling", name);
}

std::function<std::unique_ptr<OdometryModel>()> odometry_of(const std::string& name, const FilterSettings& settings) {
    return chosen<std::function<std::unique_ptr<OdometryModel>()>>(
        {{"as-logged", [noise = settings.rbpf.motion] { return std::make_unique<FixedOdometry>(noise); }},
         {"learnt",
          [learning = settings.method.odometry_learning] { return std::make_unique<LearntOdometry>(learning); }}},
        "odometry", name);
}

FilterStrategies strategies_of(const FilterSettings& settings, const DetectorTable& detectors) {
    const MethodParts parts = parts_of(settings.method);
    FilterStrategies strategies{
        .detector = detectors.make(parts.detector, settings.method.detection, settings.rbpf.motion),
        .corrections = {search_of(parts.search, settings.method), trust_of(parts.trust, settings.method)},
        .resampling = resampling_of(parts.resampling, settings.method),
        .odometry = odometry_of(parts.odometry, settings)};
    std::erase(strategies.corrections, nullptr);
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

MethodParts parts_of(const MethodSettings& settings) {
    MethodParts parts = method_of(settings.method).parts;
    for (const auto part : {&MethodParts::detector, &MethodParts::search, &MethodParts::trust, &MethodParts::resampling,
                            &MethodParts::odometry}) {
        if (!(settings.parts.*part).empty()) {
            parts.*part = settings.parts.*part;
        }
    }
    return parts;
}

std::unique_ptr<Rbpf> make_filter(const FilterSettings& settings, const DetectorTable& detectors, ThreadPool& threads) {
    RbpfSettings rbpf = settings.rbpf;
    if (method_of(settings.method.method).single_hypothesis) {
        rbpf.particles = 1;
    }
    return std::make_unique<Rbpf>(rbpf, threads, strategies_of(settings, detectors));
}

}  // namespace ddtool

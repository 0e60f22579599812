#include "ddtool/methods/detector_table.hpp"

#include <cmath>
#include <filesystem>
#include <utility>

#include "ddtool/base/error.hpp"
#include "ddtool/network/load_model.hpp"
#include "ddtool/network/network_detector.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "ddtool/swarm/swarm_detectors.hpp"
#include "ddtool/system/settings.hpp"
#include "system/fingerprint.hpp"

namespace ddtool {
namespace {

/// The gate "in-doubt": runs the detector only where matching is in doubt, and there only once in settings.every_m of
/// driving.
class AskedInDoubt {
public:
    AskedInDoubt(DegeneracyDetector detector, const DetectionSettings& settings)
        : detector_(std::move(detector)), settings_(settings) {}

    Degeneracy operator()(const ParticleSnapshot& swarm) {
        since_answer_m_ += std::hypot(swarm.odometry_motion.x_m, swarm.odometry_motion.y_m);
        if (step_spread_(swarm).degree < settings_.doubt_share) {
            answer_ = {};
            since_answer_m_ = INFINITY;
        } else if (since_answer_m_ >= settings_.every_m) {
            answer_ = detector_(swarm);
            since_answer_m_ = 0.0;
        }
        return answer_;
    }

private:
    DegeneracyDetector detector_;
    DegeneracyDetector step_spread_ = step_spread_detector();
    DetectionSettings settings_;
    Degeneracy answer_;
    double since_answer_m_ = INFINITY;
};

}  // namespace

DetectorTable::DetectorTable()
    : makers_{
          {"none", [](const Ingredients&) { return DegeneracyDetector(); }},
          {"covariance", [](const Ingredients& from) { return covariance_detector(from.settings.covariance_sd_m); }},
          {"step-spread", [](const Ingredients&) { return step_spread_detector(); }},
          {"neff", [](const Ingredients&) { return effective_size_detector(); }},
          {"always", [](const Ingredients&) { return always_degenerate(); }},
          {"oracle", [](const Ingredients& from) { return oracle_detector(from.noise, from.truth); }},
          {shipped_model_name, [](const Ingredients&) { return network_detector(shipped_model()); }},
      },
      file_kinds_{{".safetensors",
                   [](const std::string& file) { return network_detector(load_model(std::filesystem::path(file))); }}} {}

std::vector<std::string> DetectorTable::names() const {
    std::vector<std::string> names;
    for (const auto& [name, maker] : makers_) {
        names.push_back(name);
    }
    return names;
}

DegeneracyDetector DetectorTable::make(const std::string& name, const DetectionSettings& settings,
                                       const MotionNoise& noise) const {
    if (const auto found = makers_.find(name); found != makers_.end()) {
        return found->second({settings, noise, truth_});
    }
    const auto kind = file_kinds_.find(std::filesystem::path(name).extension().string());
    if (kind == file_kinds_.end()) {
        std::vector<std::string> expected = names();
        for (const auto& [ending, maker] : file_kinds_) {
            expected.push_back("a file *" + ending);
        }
        throw UsageError("filter.detector: expected " + joined(expected) + ", not '" + name + "'");
    }
    return kind->second(name);
}

std::string DetectorTable::model_fingerprint(const std::string& name) const {
    if (name == shipped_model_name) {
        return shipped_model_fingerprint();
    }
    return makers_.contains(name) ? "" : file_fingerprint(name);
}

std::vector<std::string> gate_names() { return {"in-doubt", "none"}; }

std::string usual_gate(const std::string& detector) {
    return detector == "none" || detector == "always" || detector == "oracle" ? "none" : "in-doubt";
}

DegeneracyDetector gated(const std::string& gate, DegeneracyDetector detector, const DetectionSettings& settings) {
    if (gate != "in-doubt" && gate != "none") {
        throw UsageError("filter.gate: expected " + joined(gate_names()) + ", not '" + gate + "'");
    }
    return gate == "none" || !detector ? detector : AskedInDoubt(std::move(detector), settings);
}

}  // namespace ddtool

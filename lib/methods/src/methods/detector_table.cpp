#include "ddtool/methods/detector_table.hpp"

#include <cmath>
#include <filesystem>
#include <memory>

#include "ddtool/base/error.hpp"
#include "ddtool/network/load_model.hpp"
#include "ddtool/network/network_detector.hpp"
#include "ddtool/network/shipped_model.hpp"
#include "ddtool/swarm/swarm_detectors.hpp"
#include "ddtool/system/settings.hpp"
#include "system/fingerprint.hpp"

namespace ddtool {

DetectorTable::DetectorTable()
    : makers_{
          {"none", [](const DetectionSettings&, const MotionNoise&) { return DegeneracyDetector(); }},
          {"covariance", [](const DetectionSettings& settings,
                            const MotionNoise&) { return covariance_detector(settings.covariance_sd_m); }},
          {"step-spread", [](const DetectionSettings&, const MotionNoise&) { return step_spread_detector(); }},
          {"neff", [](const DetectionSettings&, const MotionNoise&) { return effective_size_detector(); }},
          {"always", [](const DetectionSettings&, const MotionNoise&) { return always_degenerate(); }},
          {"oracle", [](const DetectionSettings&, const MotionNoise& noise) { return oracle_detector(noise); }},
          {native::shipped_model_name, [](const DetectionSettings&,
                                          const MotionNoise&) { return native::network_detector(native::shipped_model()); }},
      },
      file_kinds_{{".safetensors",
                   [](const std::string& file) { return native::network_detector(native::load_model(std::filesystem::path(file))); }}} {}

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
        return consulted_in_doubt(found->second(settings, noise), settings);
    }
    const auto kind = file_kinds_.find(std::filesystem::path(name).extension().string());
    if (kind == file_kinds_.end()) {
        std::vector<std::string> expected = names();
        for (const auto& [ending, maker] : file_kinds_) {
            expected.push_back("a file *" + ending);
        }
        throw UsageError("filter.detector: expected " + joined(expected) + ", not '" + name + "'");
    }
    return consulted_in_doubt(kind->second(name), settings);
}

std::string DetectorTable::model_fingerprint(const std::string& name) const {
    if (name == native::shipped_model_name) {
        return native::shipped_model_fingerprint();
    }
    return makers_.contains(name) ? "" : file_fingerprint(name);
}

DegeneracyDetector consulted_in_doubt(DegeneracyDetector detector, const DetectionSettings& settings) {
    if (!detector || (settings.doubt_share <= 0.0 && settings.every_m <= 0.0)) {
        return detector;
    }
    struct Last {
        Degeneracy degeneracy;
        double since_m = INFINITY;
    };
    // The copies of a std::function share what was said last.
    return [detector = std::move(detector), settings, last = std::make_shared<Last>(),
            doubt = step_spread_detector()](const ParticleSnapshot& swarm) {
        last->since_m += std::hypot(swarm.odometry_motion.x_m, swarm.odometry_motion.y_m);
        if (doubt(swarm).degree < settings.doubt_share) {
            *last = {};
        } else if (last->since_m >= settings.every_m) {
            *last = {detector(swarm), 0.0};
        }
        return last->degeneracy;
    };
}

}  // namespace ddtool

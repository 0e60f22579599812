#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

struct DetectionSettings {
    double covariance_sd_m = 0.1;  ///< threshold of the detector covariance
    /// The detector is consulted where matching is in doubt: where the match left this share of the step swarm's
    /// predicted spread, or more. Elsewhere the degree is 0. 0 consults always.
    double doubt_share = 0.3;
    /// Between two consultations the robot drives this far; the degree stays what it was.
    double every_m = 0.3;
};

/// The detectors by name, and by the ending of their file: rules, the network that is carried inside, networks in
/// files.
class DetectorTable {
public:
    using Maker = std::function<DegeneracyDetector(const DetectionSettings& settings, const MotionNoise& noise)>;
    using FileMaker = std::function<DegeneracyDetector(const std::string& file)>;

    /// Those that need no LibTorch: none, always, covariance, step-spread, neff, oracle, native::shipped_model_name,
    /// and files that end with ".safetensors".
    DetectorTable();
    /// Makes detectors of files that end so, such as ".pt".
    void add_file_kind(const std::string& ending, FileMaker maker) { file_kinds_[ending] = std::move(maker); }

    /// Without the files.
    [[nodiscard]] std::vector<std::string> names() const;
    /// An empty function for "none". Throws UsageError for a name that is none of these.
    [[nodiscard]] DegeneracyDetector make(const std::string& name, const DetectionSettings& settings,
                                          const MotionNoise& noise) const;
    /// Of the network's weights, which decide with the settings what a detector says; empty for a rule.
    [[nodiscard]] std::string model_fingerprint(const std::string& name) const;

private:
    std::map<std::string, Maker> makers_;
    std::map<std::string, FileMaker> file_kinds_;
};

/// The detector, asked only where and as often as the settings say.
DegeneracyDetector consulted_in_doubt(DegeneracyDetector detector, const DetectionSettings& settings);

}  // namespace ddtool

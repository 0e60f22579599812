#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/motion_model.hpp"

namespace ddtool {

class ScanTruth;

struct DetectionSettings {
    double covariance_sd_m = 0.1;  ///< threshold of the detector covariance
    /// Of the gate in-doubt: matching is in doubt where it left this share of the step swarm's predicted spread, or
    /// more. Elsewhere the detector is not asked and the degree is 0. At 0 matching is always in doubt.
    double doubt_share = 0.3;
    /// Of the gate in-doubt: once the detector has answered, the robot drives this far before it is asked again. The
    /// degree stays what it was meanwhile.
    double every_m = 0.3;
};

/// The detectors by name, and by the ending of their file: rules, the network that is carried inside, networks in
/// files.
class DetectorTable {
public:
    using FileMaker = std::function<DegeneracyDetector(const std::string& file)>;

    /// Those that need no LibTorch: none, always, covariance, step-spread, neff, oracle, native::shipped_model_name,
    /// and files that end with ".safetensors".
    DetectorTable();
    /// Tells the detectors that are made from now on where the truth of their scans will be
    /// (SensorStream::tell_truth()); `oracle` needs it.
    void know(std::shared_ptr<const ScanTruth> truth) { truth_ = std::move(truth); }
    /// A detector of your own under a name of its own, or in the place of the one that has the name.
    void add(const std::string& name, DegeneracyDetector detector) {
        makers_[name] = [detector = std::move(detector)](const Ingredients&) { return detector; };
    }
    /// Makes detectors of files that end so, such as ".pt".
    void add_file_kind(const std::string& ending, FileMaker maker) { file_kinds_[ending] = std::move(maker); }

    /// Without the files.
    [[nodiscard]] std::vector<std::string> names() const;
    /// The detector itself, which answers whenever it is called; an empty function for "none". Throws UsageError for a
    /// name that is none of these.
    [[nodiscard]] DegeneracyDetector make(const std::string& name, const DetectionSettings& settings,
                                          const MotionNoise& noise) const;
    /// Of the network's weights, which decide with the settings what a detector says; empty for a rule.
    [[nodiscard]] std::string model_fingerprint(const std::string& name) const;

private:
    struct Ingredients {
        const DetectionSettings& settings;
        const MotionNoise& noise;
        const std::shared_ptr<const ScanTruth>& truth;
    };

    std::map<std::string, std::function<DegeneracyDetector(const Ingredients&)>> makers_;
    std::map<std::string, FileMaker> file_kinds_;
    std::shared_ptr<const ScanTruth> truth_;
};

/// The gates by name: in-doubt, none.
std::vector<std::string> gate_names();

/// The gate of a detector where nobody names one: none for `none`, `always` and `oracle`, which are there to be
/// compared with and have to answer at every update, in-doubt for all others.
std::string usual_gate(const std::string& detector);

/// The detector behind the gate of that name. An empty detector stays empty. Throws UsageError for an unknown gate.
DegeneracyDetector gated(const std::string& gate, DegeneracyDetector detector, const DetectionSettings& settings);

}  // namespace ddtool

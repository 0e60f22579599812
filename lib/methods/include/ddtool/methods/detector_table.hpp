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
    double covariance_sd_m = 0.1;  ///< threshold of the detector "covariance", as a standard deviation
    /// For the gate "in-doubt": matching counts as doubtful if it left at least this share of the spread that was
    /// predicted for the step. Elsewhere the detector is not run and the degree is 0. With 0, matching always counts as
    /// doubtful.
    double doubt_share = 0.3;
    /// For the gate "in-doubt": after the detector has run, the robot drives this far before it runs again. Until then
    /// the degree stays the same.
    double every_m = 0.3;
};

/// The detectors by name, and for networks in files by the ending of the file. The named ones are rules and the
/// networks that are embedded in the program.
class DetectorTable {
public:
    using FileMaker = std::function<DegeneracyDetector(const std::string& file)>;

    /// Has the detectors that need no LibTorch: none, always, covariance, step-spread, neff, oracle,
    /// shipped_model_name, paper_model_name, and files that end with ".safetensors".
    DetectorTable();
    /// Gives the detectors made from now on the place where the true values of their scans will be
    /// (SensorStream::tell_truth()). The detector "oracle" needs it.
    void know(std::shared_ptr<const ScanTruth> truth) { truth_ = std::move(truth); }
    /// Adds a detector under a name of its own, or replaces the one that has this name. Every make() returns a copy of
    /// it.
    void add(const std::string& name, DegeneracyDetector detector) {
        makers_[name] = [detector = std::move(detector)](const Ingredients&) { return detector; };
    }
    /// Adds a maker for detectors from files with this ending, such as ".pt".
    void add_file_kind(const std::string& ending, FileMaker maker) { file_kinds_[ending] = std::move(maker); }

    /// The names of all detectors except those in files.
    [[nodiscard]] std::vector<std::string> names() const;
    /// Makes a detector without a gate, so that it computes its answer at every call; "none" gives an empty function.
    /// Throws UsageError for a name that is neither in the table nor that of a file with a known ending, and Error for
    /// a file that cannot be loaded.
    [[nodiscard]] DegeneracyDetector make(const std::string& name, const DetectionSettings& settings,
                                          const MotionNoise& noise) const;
    /// The gate that a detector gets if the settings name none: "none" for the library's detectors none, always and
    /// oracle, and "in-doubt" for all others, including added ones and those in files.
    [[nodiscard]] static std::string usual_gate(const std::string& detector);
    /// Fingerprint of the network's weights, which together with the settings determine the detector's answers; empty
    /// for a rule.
    [[nodiscard]] std::string model_fingerprint(const std::string& name) const;

private:
    struct Ingredients {
        const DetectionSettings& settings;
        const MotionNoise& noise;
        const std::shared_ptr<const ScanTruth>& truth;
    };

    using Maker = std::function<DegeneracyDetector(const Ingredients&)>;
    struct Row;
    static const std::vector<Row>& rows();

    std::map<std::string, Maker> makers_;
    std::map<std::string, FileMaker> file_kinds_;
    std::shared_ptr<const ScanTruth> truth_;
};

/// The names of the gates: in-doubt and none. A gate decides at which updates a detector runs.
std::vector<std::string> gate_names();

/// Puts the detector behind the gate of that name. An empty detector stays empty. Throws UsageError for an unknown
/// gate.
DegeneracyDetector gated(const std::string& gate, DegeneracyDetector detector, const DetectionSettings& settings);

}  // namespace ddtool

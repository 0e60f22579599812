#include "ddtool/methods/detector_table.hpp"

#include <algorithm>
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

constexpr const char* in_doubt = "in-doubt";
constexpr const char* no_gate = "none";

}  // namespace

/// A detector of the library: its name, the gate that it gets unless the settings name another, and how it is made.
struct DetectorTable::Row {
    std::string name;
    const char* gate;
    Maker make;
};

/// Detectors that serve as comparisons have no gate, because they have to run at every update.
const std::vector<DetectorTable::Row>& DetectorTable::rows() {
    static const std::vector<Row> table{
        {"none", no_gate, [](const Ingredients&) { return DegeneracyDetector(); }},
        {"covariance", in_doubt,
         [](const Ingredients& from) { return covariance_detector(from.settings.covariance_sd_m); }},
        {"step-spread", in_doubt, [](const Ingredients&) { return step_spread_detector(); }},
        {"neff", in_doubt, [](const Ingredients&) { return effective_size_detector(); }},
        {"always", no_gate, [](const Ingredients&) { return always_degenerate(); }},
        {"oracle", no_gate, [](const Ingredients& from) { return oracle_detector(from.noise, from.truth); }},
        {shipped_model_name, in_doubt, [](const Ingredients&) { return network_detector(shipped_model()); }},
        {paper_model_name, in_doubt,
         [](const Ingredients&) { return network_detector(shipped_model(paper_model_name)); }},
    };
    return table;
}

DetectorTable::DetectorTable()
    : file_kinds_{{".safetensors",
                   [](const std::string& file) { return network_detector(load_model(std::filesystem::path(file))); }}} {
    for (const Row& row : rows()) {
        makers_.emplace(row.name, row.make);
    }
}

std::string DetectorTable::usual_gate(const std::string& detector) {
    const auto row = std::ranges::find(rows(), detector, &Row::name);
    return row != rows().end() ? row->gate : in_doubt;
}

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
    if (is_shipped(name)) {
        return shipped_model_fingerprint(name);
    }
    return makers_.contains(name) ? "" : file_fingerprint(name);
}

std::vector<std::string> gate_names() { return {in_doubt, no_gate}; }

DegeneracyDetector gated(const std::string& gate, DegeneracyDetector detector, const DetectionSettings& settings) {
    if (gate != in_doubt && gate != no_gate) {
        throw UsageError("filter.gate: expected " + joined(gate_names()) + ", not '" + gate + "'");
    }
    return gate == no_gate || !detector ? detector : AskedInDoubt(std::move(detector), settings);
}

}  // namespace ddtool

#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "ddtool/base/error.hpp"
#include "study/judge/evaluation.hpp"
#include "train/engine.hpp"

namespace ddtool::ablation {

/// A trained network and what it reaches on the part test of its own label and split.
struct TrainedModel {
    std::filesystem::path file;
    Confusion confusion;
    double auc = 0.0;
};

/// A training was asked to stop; the same command goes on.
class TrainingStopped : public Error {
public:
    TrainingStopped() : Error("stopped; the same command goes on where it was") {}
};

/// How trainings and their models are run.
struct Machine {
    std::string device = "cpu";
    std::size_t threads = 0;  ///< 0: all cores
};

/// Trained models in a folder, by the fingerprints of their settings and the data set: what is there is not trained
/// again, and a training that was stopped goes on.
class ModelStore {
public:
    ModelStore(const learning::Engine& engine, std::filesystem::path data, std::filesystem::path folder,
               Machine machine);

    /// Trains, exports and tests the network unless that has been done. Throws Error, a TrainingStopped for a training
    /// that was asked to stop.
    TrainedModel model_of(const learning::TrainSettings& settings);
    [[nodiscard]] const dataset::Dataset& data() const { return data_; }

private:
    void train(const learning::TrainSettings& settings, const std::filesystem::path& folder) const;
    [[nodiscard]] Json tested(const learning::TrainSettings& settings, const std::filesystem::path& file) const;

    const learning::Engine& engine_;
    std::filesystem::path data_folder_;
    dataset::Dataset data_;
    std::filesystem::path folder_;
    Machine machine_;
    std::string data_id_;
};

}  // namespace ddtool::ablation

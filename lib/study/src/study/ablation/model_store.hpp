#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "jobs/store.hpp"
#include "study/judge/evaluation.hpp"
#include "train/engine.hpp"

namespace ddtool::ablation {

/// A trained network and its results on the test part of the label and split that it was trained on.
struct TrainedModel {
    std::filesystem::path file;
    Confusion confusion;
    double auc = 0.0;
};

/// The device and threads that trainings and their models run on.
struct Machine {
    std::string device = "cpu";
    std::size_t threads = 0;  ///< 0: all cores
};

/// Trained models in a folder, by the ids of their settings and the data set: a folder ID for each, with result.json
/// (see jobs::Store), model.pt and what its training wrote.
class ModelStore {
public:
    ModelStore(const train::Engine& engine, std::filesystem::path data, std::filesystem::path folder, Machine machine);

    /// Returns everything that decides the model that these settings give.
    [[nodiscard]] jobs::Key key_of(const train::TrainSettings& settings) const;
    /// Returns nullopt for a network that has not been trained and tested and, after a warning, for one with a damaged
    /// file.
    [[nodiscard]] std::optional<TrainedModel> find(const train::TrainSettings& settings) const;
    /// Trains, exports and tests the network. A training that was stopped earlier is continued. Throws Error, and
    /// jobs::Stopped for a training that the user asked to stop.
    [[nodiscard]] TrainedModel make(const train::TrainSettings& settings) const;
    [[nodiscard]] const dataset::Dataset& data() const { return data_; }

private:
    void run_training(const train::TrainSettings& settings, const std::filesystem::path& folder,
                      const std::filesystem::path& model) const;
    [[nodiscard]] TrainedModel tested(const train::TrainSettings& settings, const std::filesystem::path& file) const;

    const train::Engine& engine_;
    std::filesystem::path data_folder_;
    dataset::Dataset data_;
    jobs::Store models_;
    Machine machine_;
    std::string data_id_;
};

}  // namespace ddtool::ablation

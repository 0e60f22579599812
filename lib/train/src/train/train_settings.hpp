#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dataset/sample_record.hpp"
#include "ddtool/network/image_settings.hpp"
#include "system/setting_rows.hpp"

namespace ddtool::train {

/// Random changes of a swarm that do not change its label (docs/training.md).
struct AugmentationSettings {
    bool rotate = true;              ///< by any angle
    bool flip = true;                ///< mirrored with probability 1/2
    bool resample_particles = true;  ///< a random choice of fewer particles
    std::size_t least_particles = 15;
};

struct OptimizerSettings {
    std::string name = "adam";  ///< adam, rmsprop or adamw
    double learning_rate = 1e-3;
    double weight_decay = 1e-4;
    /// the share of all steps in which the learning rate rises linearly; it then falls as half a cosine
    double warm_up_share = 0.05;
    double final_rate_share = 0.01;
    double largest_gradient_norm = 1.0;  ///< longer gradients are scaled down to this norm
};

/// Everything that, with the data set, decides the trained weights.
struct TrainSettings {
    std::string model = "ddmodel-lite";
    std::string label = "fisher";
    std::string split = "held_out";
    ImageSettings image{.swarm = Swarm::response};
    AugmentationSettings augmentation{};
    std::string loss = "cross-entropy";  ///< cross-entropy or bce
    bool class_weights = true;           ///< each class counts the same, however many samples it has
    OptimizerSettings optimizer{};
    std::size_t epochs = 30;
    std::size_t batch_size = 32;       ///< of each rank
    std::size_t patience_epochs = 10;  ///< without a better validation loss before training stops; 0: never stops early
    std::string precision = "bf16";    ///< fp32 or bf16 (mixed)
    std::uint64_t seed = 1;
};
void to_json(Json& json, const TrainSettings& settings);
void from_json(const Json& json, TrainSettings& settings);

/// The description of every setting, in the order of the settings in JSON.
const std::vector<Setting>& train_setting_list();

/// Reads a configuration. Throws UsageError for an invalid value, naming the setting, with `path` in front if that is
/// not empty. The model's name is checked where the network is made.
TrainSettings train_settings_from_json(const Json& json, const std::string& path = "");

/// The label rule and the split that the settings name. Both functions throw UsageError for an unknown name.
dataset::LabelRule label_rule_of(const TrainSettings& settings);
dataset::Split split_of(const TrainSettings& settings);

/// Checks settings that have been read already in the same way.
void expect_valid(const TrainSettings& settings);

}  // namespace ddtool::train

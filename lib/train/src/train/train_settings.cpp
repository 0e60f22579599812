#include "train/train_settings.hpp"

#include <array>

#include "system/expect.hpp"

namespace ddtool::train {
namespace {

constexpr std::array<const char*, 2> loss_names{"cross-entropy", "bce"};
constexpr std::array<const char*, 3> optimizer_names{"adam", "rmsprop", "adamw"};
constexpr std::array<const char*, 2> precision_names{"fp32", "bf16"};
constexpr double smallest = 1e-12;  ///< of what has to be above zero

void expect_valid(const OptimizerSettings& optimizer) {
    expect_one_of("optimizer.name", optimizer.name, optimizer_names);
    expect_between("optimizer.learning_rate", optimizer.learning_rate, smallest, 10.0);
    expect_between("optimizer.weight_decay", optimizer.weight_decay, 0.0, 1.0);
    expect_between("optimizer.warm_up_share", optimizer.warm_up_share, 0.0, 1.0);
    expect_between("optimizer.final_rate_share", optimizer.final_rate_share, 0.0, 1.0);
    expect_between("optimizer.largest_gradient_norm", optimizer.largest_gradient_norm, smallest, 1e12);
}

}  // namespace

dataset::LabelRule label_rule_of(const TrainSettings& settings) {
    return dataset::LabelRule{expect_one_of("label", settings.label, dataset::label_rule_names)};
}

dataset::Split split_of(const TrainSettings& settings) {
    return dataset::Split{expect_one_of("split", settings.split, dataset::split_names)};
}

void expect_valid(const TrainSettings& settings) {
    constexpr double most_epochs = 1e6;
    label_rule_of(settings);
    split_of(settings);
    expect_valid(settings.image);
    expect_between("augmentation.least_particles", static_cast<double>(settings.augmentation.least_particles), 1, 1e6);
    expect_one_of("loss", settings.loss, loss_names);
    expect_valid(settings.optimizer);
    expect_between("epochs", static_cast<double>(settings.epochs), 1, most_epochs);
    expect_between("batch_size", static_cast<double>(settings.batch_size), 1, 65536);
    expect_between("patience_epochs", static_cast<double>(settings.patience_epochs), 0, most_epochs);
    expect_one_of("precision", settings.precision, precision_names);
}

}  // namespace ddtool::train

#include "train/train_settings.hpp"

#include <span>

#include "network/image_setting_rows.hpp"
#include "system/expect.hpp"

namespace ddtool::train {
namespace {

Allowed word_of(std::span<const char* const> names) { return Allowed::one_of({names.begin(), names.end()}); }

const SettingTable<AugmentationSettings>& augmentation_rows() {
    using Augmentation = AugmentationSettings;
    static const SettingTable<Augmentation> rows{
        {"rotate", &Augmentation::rotate, Allowed::flag(), "", "Whether a swarm is rotated by a random angle."},
        {"flip", &Augmentation::flip, Allowed::flag(), "", "Whether every other swarm is mirrored, by chance."},
        {"resample_particles", &Augmentation::resample_particles, Allowed::flag(), "",
         "Whether a random choice of fewer particles stands for a swarm."},
        {"least_particles", &Augmentation::least_particles, Allowed::whole(1, 1e6), "",
         "Such a choice has at least so many particles."},
    };
    return rows;
}

const SettingTable<OptimizerSettings>& optimizer_rows() {
    using Optimizer = OptimizerSettings;
    constexpr double smallest = 1e-12;
    static const SettingTable<Optimizer> rows{
        {"name", &Optimizer::name, Allowed::one_of({"adam", "rmsprop", "adamw"}), "", "How the loss is minimised."},
        {"learning_rate", &Optimizer::learning_rate, Allowed::number(smallest, 10.0), "",
         "The highest rate, after the warm-up."},
        {"weight_decay", &Optimizer::weight_decay, Allowed::number(0.0, 1.0), "", "Decay of the weights per step."},
        {"warm_up_share", &Optimizer::warm_up_share, Allowed::number(0.0, 1.0), "",
         "Share of all steps in which the rate rises linearly; then it falls as half a cosine."},
        {"final_rate_share", &Optimizer::final_rate_share, Allowed::number(0.0, 1.0), "",
         "The rate ends at this share of the highest."},
        {"largest_gradient_norm", &Optimizer::largest_gradient_norm, Allowed::number(smallest, 1e12), "",
         "Longer gradients are cut to this length."},
    };
    return rows;
}

const SettingTable<TrainSettings>& train_rows() {
    using Train = TrainSettings;
    static const SettingTable<Train> rows{
        {"model", &Train::model, Allowed::text(), "",
         "The network: ddmodel, ddmodel-lite, a variant of them, or mobilenetv3.", "docs/models.md"},
        {"label", &Train::label, word_of(dataset::label_rule_names), "", "What the network learns to tell.",
         "docs/labels.md"},
        {"split", &Train::split, word_of(dataset::split_names), "",
         "How samples are divided: held_out by whole scenes, paper at random.", "docs/dataset.md"},
        {"image", &Train::image, image_setting_rows()},
        {"augmentation", &Train::augmentation, augmentation_rows()},
        {"loss", &Train::loss, Allowed::one_of({"cross-entropy", "bce"}), "", "What is minimised."},
        {"class_weights", &Train::class_weights, Allowed::flag(), "",
         "Whether each class counts the same, however many samples it has."},
        {"optimizer", &Train::optimizer, optimizer_rows()},
        {"epochs", &Train::epochs, Allowed::whole(1, 1e6), "",
         "Number of passes over the training part; the schedule of the rate depends on it."},
        {"batch_size", &Train::batch_size, Allowed::whole(1, 65536), "", "Number of images per step, of each rank."},
        {"patience_epochs", &Train::patience_epochs, Allowed::whole(0, 1e6), "",
         "Training stops after so many epochs without a better validation loss; 0 never stops early."},
        {"precision", &Train::precision, Allowed::one_of({"fp32", "bf16"}), "",
         "Precision of the computation; bf16 is mixed."},
        {"seed", &Train::seed, Allowed::seed(), "", "Weights, order and augmentation follow from it."},
    };
    return rows;
}

}  // namespace

const std::vector<Setting>& train_setting_list() { return train_rows().settings(); }

void to_json(Json& json, const TrainSettings& settings) { json = train_rows().json(settings); }

void from_json(const Json& json, TrainSettings& settings) { train_rows().read(json, settings); }

dataset::LabelRule label_rule_of(const TrainSettings& settings) {
    return dataset::LabelRule{expect_one_of("label", settings.label, dataset::label_rule_names)};
}

dataset::Split split_of(const TrainSettings& settings) {
    return dataset::Split{expect_one_of("split", settings.split, dataset::split_names)};
}

TrainSettings train_settings_from_json(const Json& json, const std::string& path) {
    const TrainSettings settings = train_rows().checked(json, path);
    expect_valid(settings.image, path.empty() ? "image" : path + ".image");
    return settings;
}

void expect_valid(const TrainSettings& settings) { (void)train_settings_from_json(Json(settings)); }

}  // namespace ddtool::train

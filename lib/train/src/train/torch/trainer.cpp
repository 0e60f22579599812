#include "train/torch/trainer.hpp"

#include <algorithm>
#include <cmath>

#include "ddtool/base/error.hpp"
#include "system/fingerprint.hpp"
#include "system/folder.hpp"
#include "system/log.hpp"
#include "train/torch/batch_tensors.hpp"
#include "train/torch/losses.hpp"
#include "train/torch/mixed_precision.hpp"
#include "train/torch/optimizers.hpp"
#include "train/torch/validation.hpp"

namespace ddtool::train_torch {
namespace {

using train::TrainSettings;

constexpr const char* last_name = "last.pt";
constexpr const char* best_name = "best.pt";

/// The labelled samples of a part. Throws Error if one of the classes has none.
std::vector<std::size_t> part_of(const dataset::Dataset& data, const TrainSettings& settings, dataset::Part part,
                                 const std::filesystem::path& folder) {
    const dataset::LabelRule rule = train::label_rule_of(settings);
    std::vector<std::size_t> samples = data.part(rule, train::split_of(settings), part);
    for (const dataset::Label label : {dataset::Label::not_degenerate, dataset::Label::degenerate}) {
        if (std::ranges::none_of(samples,
                                 [&](std::size_t sample) { return data.sample(sample).label_of(rule) == label; })) {
            throw Error(folder.string() + ": no sample of the class " +
                        dataset::class_names.at(static_cast<std::size_t>(label)) + " in the part " +
                        dataset::part_names.at(dataset::index_of(part)) + " of the split " + settings.split +
                        " for the label " + settings.label);
        }
    }
    return samples;
}

std::shared_ptr<Network> new_network(const TrainSettings& settings, torch::Device device) {
    torch::manual_seed(settings.seed);
    std::shared_ptr<Network> network = make_network(settings.model, settings.image.size_px);
    network->to(device);
    return network;
}

double wall_time_s() {
    return std::chrono::duration<double>(std::chrono::system_clock::now().time_since_epoch()).count();
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void expect_same_run(const train::TrainingState& now, const train::TrainingState& then,
                     const std::filesystem::path& path) {
    const auto expect_same = [&](const char* what, const Json& ours, const Json& theirs) {
        if (ours != theirs) {
            throw UsageError(path.string() + ": cannot be resumed with another " + what + ": it was " +
                             Json::diff(ours, theirs).at(0).value("value", theirs).dump() +
                             ", see the settings: " + theirs.dump());
        }
    };
    expect_same("configuration", now.settings, then.settings);
    expect_same("data set", now.dataset, then.dataset);
    expect_same("number of ranks", now.world_size, then.world_size);
}

}  // namespace

Trainer::Trainer(const train::TrainRequest& request, const Communicator& communicator)
    : request_(request),
      communicator_(communicator),
      device_(request.device),
      data_(request.data),
      train_samples_(part_of(data_, request.settings, dataset::Part::train, request.data)),
      validation_samples_(part_of(data_, request.settings, dataset::Part::validation, request.data)),
      weights_(class_weights(data_, train_samples_, request.settings)),
      network_(new_network(request.settings, device_)),
      parameters_(network_->parameters()),
      optimizer_(make_optimizer(request.settings.optimizer, parameters_)),
      progress_("training " + request.settings.model, "samples") {
    state_.settings = request.settings;
    state_.dataset = file_fingerprint(request.data / dataset::manifest_name);
    state_.world_size = communicator.rank().world_size;
    if (communicator_.leads()) {
        made_folder(request_.out);
    }
    if (request.resume) {
        resume();
    }
    communicator_.copy_from_leader(parameters_);
    communicator_.copy_from_leader(network_->buffers());
    communicator_.join_statistics(*network_);
}

void Trainer::resume() {
    const std::filesystem::path last = request_.out / last_name;
    if (!std::filesystem::exists(last)) {
        log_info(last.string() + " is not there: training starts from the beginning");
        return;
    }
    Checkpoint checkpoint(last, device_);
    const train::TrainingState before = checkpoint.state();
    expect_same_run(state_, before, last);
    checkpoint.restore(*network_, *optimizer_);
    state_ = before;
    log_info("going on after epoch " + std::to_string(state_.epoch) + ", step " + std::to_string(state_.step));
}

train::TrainResult Trainer::run() {
    while (!finished(state_) && !stopped()) {
        run_epoch();
    }
    const train::EpochRecord* const best = train::best_epoch(state_);
    return {.best = request_.out / best_name,
            .best_epoch = best == nullptr ? train::EpochRecord{} : *best,
            .epochs = state_.epoch,
            .interrupted = !finished(state_)};
}

void Trainer::run_epoch() {
    const TrainSettings& settings = state_.settings;
    const train::EpochPlan plan =
        train::training_epoch(train_samples_, settings.batch_size, communicator_.rank(), settings.seed, state_.epoch);
    const std::size_t steps = plan.batches.size();
    train::BatchLoader loader(data_, plan, settings, &settings.augmentation, state_.step);
    train::Batch batch;
    network_->train();
    while (!stopped() && loader.next(batch)) {
        take_step(batch, steps);
        show_progress(steps);
        save_if_due();
    }
    if (state_.step == steps) {
        end_epoch(steps);
    }
    save_last();
}

void Trainer::take_step(train::Batch& batch, std::size_t steps_per_epoch) {
    const Clock::time_point start = Clock::now();
    const TrainSettings& settings = state_.settings;
    const BatchTensors tensors = tensors_of(batch, device_);
    torch::Tensor logits;
    {
        const MixedPrecision precision(settings.precision, device_.type());
        logits = network_->forward(tensors.images);
    }
    const torch::Tensor losses = sample_losses(settings.loss, logits, tensors.classes) * weights_.at(tensors.classes);
    const double loss = losses.sum().item<double>();
    if (!std::isfinite(loss)) {
        throw Error("the training loss is not finite in epoch " + std::to_string(state_.epoch + 1) + ", step " +
                    std::to_string(state_.step + 1) + "; a smaller optimizer.learning_rate may help, and " +
                    (request_.out / last_name).string() + " holds the training before it");
    }
    optimizer_->zero_grad();
    // Divides by the mean number of samples per rank. After the gradients are averaged over the ranks, each sample has
    // the same weight, although one rank may have one sample more than another.
    const double samples_per_rank = communicator_.sums({static_cast<double>(batch.classes.size())}).front() /
                                    static_cast<double>(state_.world_size);
    (losses.sum() / samples_per_rank).backward();
    communicator_.average_gradients(parameters_);
    torch::nn::utils::clip_grad_norm_(parameters_, settings.optimizer.largest_gradient_norm);
    set_learning_rate(*optimizer_, rate_of_step(state_.step, steps_per_epoch));
    optimizer_->step();
    state_.sums.loss += loss;
    state_.sums.correct += (logits.argmax(1) == tensors.classes).sum().item<double>();
    state_.sums.count += static_cast<double>(batch.classes.size());
    state_.sums.seconds += seconds_since(start);
    ++state_.step;
}

double Trainer::rate_of_step(std::size_t step, std::size_t steps_per_epoch) const {
    return learning_rate(state_.settings.optimizer, state_.epoch * steps_per_epoch + step,
                         state_.settings.epochs * steps_per_epoch);
}

void Trainer::end_epoch(std::size_t steps) {
    const Clock::time_point start = Clock::now();
    const train::LossSums& own = state_.sums;
    const std::vector<double> sums = communicator_.sums({own.loss, own.correct, own.count});
    ValidationResult found;
    if (communicator_.leads()) {
        found = validate(*network_, data_, validation_samples_, state_.settings, weights_, device_);
    }
    // All ranks use the figures of rank 0, so that all of them draw the same conclusions.
    const std::vector<double> figures = communicator_.of_leader({found.loss, found.accuracy, found.f1, found.auc});
    state_.history.push_back({.epoch = state_.epoch + 1,
                              .learning_rate = rate_of_step(steps - 1, steps),
                              .train_loss = sums[0] / sums[2],
                              .train_accuracy = sums[1] / sums[2],
                              .validation_loss = figures[0],
                              .validation_accuracy = figures[1],
                              .validation_f1 = figures[2],
                              .validation_auc = figures[3],
                              .seconds = own.seconds + seconds_since(start),
                              .wall_time_s = wall_time_s()});
    ++state_.epoch;
    state_.step = 0;
    state_.sums = {};
    if (communicator_.leads()) {
        if (train::best_epoch(state_)->epoch == state_.epoch) {
            write_checkpoint(request_.out / best_name, *network_, description());
        }
        train::write_history(request_.out, state_.history);
    }
}

ModelDescription Trainer::description() const {
    ModelDescription about;
    about.network = state_.settings.model;
    about.loss = state_.settings.loss;
    about.image = state_.settings.image;
    about.label = state_.settings.label;
    about.split = state_.settings.split;
    about.dataset = state_.dataset;
    about.seed = state_.settings.seed;
    about.metrics = Json::object();
    if (const train::EpochRecord* const best = train::best_epoch(state_)) {
        about.metrics = {{"epoch", best->epoch},
                         {"validation_loss", best->validation_loss},
                         {"validation_accuracy", best->validation_accuracy},
                         {"validation_f1", best->validation_f1},
                         {"validation_auc", best->validation_auc}};
    }
    return about;
}

void Trainer::save_last() {
    if (communicator_.leads()) {
        write_checkpoint(request_.out / last_name, *network_, description(), *optimizer_, state_);
    }
    last_save_ = Clock::now();
}

void Trainer::save_if_due() {
    if (seconds_since(last_save_) >= request_.checkpoint_interval_s) {
        save_last();
    }
}

void Trainer::show_progress(std::size_t steps_per_epoch) {
    const auto done = static_cast<double>(state_.epoch * steps_per_epoch + state_.step);
    const std::size_t seen =
        (state_.epoch * steps_per_epoch + state_.step) * state_.settings.batch_size * state_.world_size;
    progress_.update(done / static_cast<double>(state_.settings.epochs * steps_per_epoch), seen);
}

/// Whether the training is to stop. All ranks must stop at the same step: a rank that went on alone would wait for the
/// others without end.
bool Trainer::stopped() const { return communicator_.sums({interrupt_.made() ? 1.0 : 0.0}).front() > 0.0; }

}  // namespace ddtool::train_torch

#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include "dataset/dataset.hpp"
#include "system/interrupt.hpp"
#include "system/progress.hpp"
#include "train/batch_loader.hpp"
#include "train/engine.hpp"
#include "train/torch/checkpoint.hpp"
#include "train/torch/communicator.hpp"
#include "train/torch/losses.hpp"

namespace ddtool::train_torch {

/// Trains a network on a data set. On the CPU, with a given number of threads, the weights depend only on the settings
/// and the data, however often the training was stopped and resumed.
class Trainer {
public:
    /// Starts a training, or with request.resume continues from out/last.pt if it exists. Throws UsageError for
    /// settings that are invalid or differ from those of the checkpoint, and Error for a data set that does not fit.
    Trainer(const train::TrainRequest& request, const Communicator& communicator);

    /// Trains to the end, or until the user asks to stop. Throws Error if the loss is not a finite number; the
    /// checkpoints are kept.
    train::TrainResult run();

private:
    using Clock = std::chrono::steady_clock;

    void resume();
    void run_epoch();
    void take_step(train::Batch& batch, std::size_t steps_per_epoch);
    /// The learning rate of a step of the current epoch.
    [[nodiscard]] double rate_of_step(std::size_t step, std::size_t steps_per_epoch) const;
    void end_epoch(std::size_t steps);
    [[nodiscard]] ModelDescription description() const;
    void save_last();
    void save_if_due();
    void show_progress(std::size_t steps_per_epoch);
    [[nodiscard]] bool stopped() const;

    train::TrainRequest request_;
    const Communicator& communicator_;
    torch::Device device_;
    dataset::Dataset data_;
    std::vector<std::size_t> train_samples_;
    std::vector<std::size_t> validation_samples_;
    ClassWeights weights_;
    std::shared_ptr<Network> network_;
    std::vector<torch::Tensor> parameters_;
    std::unique_ptr<torch::optim::Optimizer> optimizer_;
    train::TrainingState state_;
    Clock::time_point last_save_ = Clock::now();
    Progress progress_;
    InterruptRequest interrupt_;
};

}  // namespace ddtool::train_torch

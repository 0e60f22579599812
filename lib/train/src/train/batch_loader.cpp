#include "train/batch_loader.hpp"

#include <array>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>

#include "ddtool/base/error.hpp"
#include "ddtool/network/particle_renderer.hpp"
#include "train/augmentation.hpp"
#include "train/draws.hpp"

namespace ddtool::train {
namespace {

/// Makes the batches, one after the other.
class BatchMaker {
public:
    BatchMaker(const dataset::Dataset& data, const EpochPlan& plan, const TrainSettings& settings,
               const AugmentationSettings* augmentation)
        : data_(data),
          seed_(plan.seed),
          epoch_(plan.epoch),
          rule_(label_rule_of(settings)),
          augmentation_(augmentation == nullptr ? std::nullopt : std::optional(*augmentation)),
          renderer_(settings.image) {}

    void make(std::span<const std::size_t> samples, Batch& batch) {
        batch.size_px = renderer_.settings().size_px;
        const std::size_t pixels = batch.size_px * batch.size_px;
        batch.images.resize(samples.size() * pixels);
        batch.classes.clear();
        for (std::size_t place = 0; place < samples.size(); ++place) {
            renderer_.render(particles_of(samples[place]), std::span(batch.images).subspan(place * pixels, pixels));
            batch.classes.push_back(class_of(samples[place]));
        }
    }

private:
    std::span<const SnapshotParticle> particles_of(std::size_t sample) {
        const std::span<const SnapshotParticle> particles = data_.particles(sample);
        if (!augmentation_) {
            return particles;
        }
        augmented_.assign(particles.begin(), particles.end());
        RandomStream random({seed_, RandomPurpose::augmentation, epoch_, sample});
        augment(augmented_, *augmentation_, random);
        return augmented_;
    }

    [[nodiscard]] std::int64_t class_of(std::size_t sample) const {
        const dataset::Label label = data_.sample(sample).label_of(rule_);
        if (label == dataset::Label::unknown) {
            throw Error("data set: sample " + std::to_string(sample) + " has no label '" +
                        dataset::label_rule_names[dataset::index_of(rule_)] + "'");
        }
        return static_cast<std::int64_t>(label);
    }

    const dataset::Dataset& data_;
    std::uint64_t seed_;
    std::uint64_t epoch_;
    dataset::LabelRule rule_;
    std::optional<AugmentationSettings> augmentation_;
    ParticleRenderer renderer_;
    std::vector<SnapshotParticle> augmented_;
};

}  // namespace

/// The thread and a ring of batches. The thread fills one batch while others wait to be taken. Taking a batch swaps it
/// with the caller's, so that memory is used again.
class BatchLoader::Worker {
public:
    Worker(BatchMaker maker, std::vector<std::vector<std::size_t>> batches, std::size_t first_step)
        : maker_(std::move(maker)),
          batches_(std::move(batches)),
          step_(first_step),
          thread_([this](const std::stop_token& stop) { run(stop); }) {}

    bool next(Batch& batch) {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return taken_ < made_ || finished_; });
        if (taken_ < made_) {
            std::swap(batch, ring_[taken_ % ring_.size()]);
            ++taken_;
            changed_.notify_all();
            return true;
        }
        if (failure_) {
            std::rethrow_exception(failure_);
        }
        return false;
    }

private:
    void run(const std::stop_token& stop) {
        std::exception_ptr failure;
        try {
            make_all(stop);
        } catch (...) {
            failure = std::current_exception();
        }
        const std::scoped_lock lock(mutex_);
        failure_ = failure;
        finished_ = true;
        changed_.notify_all();
    }

    void make_all(const std::stop_token& stop) {
        for (; step_ < batches_.size(); ++step_) {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [this] { return made_ - taken_ < ring_.size(); });
            if (stop.stop_requested()) {
                return;
            }
            Batch& batch = ring_[made_ % ring_.size()];
            lock.unlock();  // no other thread accesses a batch before it is counted as made
            maker_.make(batches_[step_], batch);
            lock.lock();
            ++made_;
            changed_.notify_all();
        }
    }

    BatchMaker maker_;
    std::vector<std::vector<std::size_t>> batches_;
    std::size_t step_;
    std::mutex mutex_;
    std::condition_variable_any changed_;
    std::array<Batch, 4> ring_;
    std::size_t made_ = 0;
    std::size_t taken_ = 0;
    bool finished_ = false;
    std::exception_ptr failure_;
    /// the last member, so that it is destroyed, and the thread joined, before the members that the thread uses
    std::jthread thread_;
};

BatchLoader::BatchLoader(const dataset::Dataset& data, EpochPlan plan, const TrainSettings& settings,
                         const AugmentationSettings* augmentation, std::size_t first_step)
    : worker_(std::make_unique<Worker>(BatchMaker(data, plan, settings, augmentation), std::move(plan.batches),
                                       first_step)) {}

BatchLoader::~BatchLoader() = default;

bool BatchLoader::next(Batch& batch) { return worker_->next(batch); }

}  // namespace ddtool::train

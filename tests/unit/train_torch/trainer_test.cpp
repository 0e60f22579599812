#include "train/torch/trainer.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "swarm_dataset.hpp"
#include "system/atomic_file.hpp"
#include "system/log.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::train_torch {
namespace {

class TrainerTest : public testing::Test {
protected:
    TrainerTest() {
        set_log_level(LogLevel::error);
        at::set_num_threads(1);
        test::write_swarm_dataset(folder_ / "data", 80);
    }

    [[nodiscard]] train::TrainRequest request(const std::string& out) const {
        train::TrainRequest request;
        request.data = folder_ / "data";
        request.out = folder_ / out;
        request.settings.image.size_px = 64;
        request.settings.batch_size = 8;
        request.settings.epochs = 4;
        return request;
    }

    static train::TrainResult train(const train::TrainRequest& request) {
        const Communicator alone(std::nullopt, torch::Device(request.device));
        return Trainer(request, alone).run();
    }

    static train::TrainResult train_and_stop_after(const train::TrainRequest& request,
                                                   std::chrono::milliseconds delay) {
        const Communicator alone(std::nullopt, torch::Device(request.device));
        Trainer trainer(request, alone);
        // The thread is joined before the trainer is destroyed: only while it exists does the signal count as a request
        // and not end the program.
        std::thread disturbance([delay] {
            std::this_thread::sleep_for(delay);
            std::raise(SIGTERM);
        });
        const train::TrainResult result = trainer.run();
        disturbance.join();
        return result;
    }

    test::TemporaryFolder folder_;
};

TEST_F(TrainerTest, LearnsWhatIsClear) {
    train::TrainRequest clear = request("out");
    clear.settings.epochs = 12;
    const train::TrainResult result = train(clear);
    EXPECT_FALSE(result.interrupted);
    EXPECT_EQ(result.best_epoch.validation_accuracy, 1.0);
    EXPECT_EQ(Checkpoint(result.best).description().metrics.at("epoch"), result.best_epoch.epoch);
}

TEST_F(TrainerTest, TheSameSeedGivesTheSameBytesAndAnotherDoesNot) {
    train::TrainRequest first = request("first");
    first.settings.epochs = 2;
    train::TrainRequest second = first;
    second.out = folder_ / "second";
    train::TrainRequest other = first;
    other.out = folder_ / "other";
    other.settings.seed = 2;
    train(first);
    train(second);
    train(other);
    EXPECT_EQ(read_file(first.out / "best.pt"), read_file(second.out / "best.pt"));
    EXPECT_NE(read_file(first.out / "best.pt"), read_file(other.out / "best.pt"));
}

TEST_F(TrainerTest, StoppedAndResumedGivesTheSameBytes) {
    const train::TrainRequest straight = request("straight");
    train(straight);
    train::TrainRequest broken = request("broken");
    broken.resume = true;
    int stops = 0;
    while (train_and_stop_after(broken, std::chrono::milliseconds(20 * stops)).interrupted) {
        ++stops;
    }
    EXPECT_GT(stops, 0);
    EXPECT_EQ(read_file(straight.out / "best.pt"), read_file(broken.out / "best.pt"));
}

TEST_F(TrainerTest, AnEpochThatFailedAtItsEndIsEndedTheSameAfterwards) {
    const train::TrainRequest straight = request("straight");
    train(straight);
    train::TrainRequest broken = request("broken");
    broken.resume = true;
    broken.checkpoint_interval_s = 0.0;
    std::filesystem::create_directories(broken.out / "best.pt");  // takes the place of the file
    EXPECT_THAT(test::thrown_text([&] { train(broken); }), testing::HasSubstr("best.pt"));
    std::filesystem::remove(broken.out / "best.pt");
    train(broken);
    const std::vector<train::EpochRecord> expected = Checkpoint(straight.out / "last.pt").state().history;
    const std::vector<train::EpochRecord> found = Checkpoint(broken.out / "last.pt").state().history;
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t epoch = 0; epoch < found.size(); ++epoch) {
        EXPECT_EQ(found[epoch].learning_rate, expected[epoch].learning_rate);
        EXPECT_EQ(found[epoch].train_loss, expected[epoch].train_loss);
        EXPECT_EQ(found[epoch].validation_loss, expected[epoch].validation_loss);
    }
}

TEST_F(TrainerTest, OnlyTheSameTrainingIsResumed) {
    train::TrainRequest first = request("out");
    first.settings.epochs = 1;
    train(first);
    first.resume = true;
    first.settings.batch_size = 4;
    EXPECT_THAT(test::thrown_text([&] { train(first); }), testing::HasSubstr("another configuration"));
}

TEST_F(TrainerTest, ALossThatIsNoNumberEndsItAndKeepsTheCheckpoint) {
    train::TrainRequest wild = request("out");
    wild.settings.epochs = 50;
    wild.settings.optimizer.learning_rate = 1e30;
    wild.settings.optimizer.largest_gradient_norm = 1e30;
    EXPECT_THAT(test::thrown_text([&] { train(wild); }), testing::HasSubstr("not finite in epoch"));
}

TEST_F(TrainerTest, APartWithoutSamplesIsNamed) {
    train::TrainRequest request = this->request("out");
    test::write_swarm_dataset(request.data, 4);
    EXPECT_THAT(test::thrown_text([&] { train(request); }),
                testing::HasSubstr("no sample of the class not_degenerate in the part validation"));
}

}  // namespace
}  // namespace ddtool::train_torch

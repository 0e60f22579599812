#include "train/torch/checkpoint.hpp"

#include <gtest/gtest.h>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::train_torch {
namespace {

constexpr std::size_t trained_size_px = 64;

ModelDescription small_lite() {
    ModelDescription about;
    about.network = "ddmodel-lite";
    about.loss = "bce";
    about.image.size_px = trained_size_px;
    about.temperature = 1.5;
    about.metrics = {{"epoch", 3}};
    return about;
}

class CheckpointTest : public testing::Test {
protected:
    std::shared_ptr<Network> network_ = make_network("ddmodel-lite", trained_size_px);
    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "best.pt";
};

TEST_F(CheckpointTest, GivesTheNetworkAndItsDescriptionBack) {
    write_checkpoint(path_, *network_, small_lite());
    Checkpoint checkpoint(path_);
    EXPECT_EQ(Json(checkpoint.description()), Json(small_lite()));
    const torch::Tensor images = torch::rand({2, 1, trained_size_px, trained_size_px});
    network_->eval();
    EXPECT_TRUE(torch::equal(checkpoint.network()->forward(images), network_->forward(images)));
}

TEST_F(CheckpointTest, TheBestHasNoTrainingToGoOnWith) {
    write_checkpoint(path_, *network_, small_lite());
    Checkpoint checkpoint(path_);
    EXPECT_EQ(test::thrown_text([&] { (void)checkpoint.state(); }), path_.string() + ": no state in this checkpoint");
}

TEST_F(CheckpointTest, ADescriptionThatNoNetworkCanHaveIsNamed) {
    ModelDescription about = small_lite();
    about.image.size_px = std::size_t{1} << 40U;
    write_checkpoint(path_, *network_, about);
    const std::string text = test::thrown_text([&] { (void)Checkpoint(path_).network(); });
    EXPECT_TRUE(text.starts_with(path_.string() + ": its description: size_px")) << text;
}

TEST_F(CheckpointTest, ACutFileIsNamed) {
    write_checkpoint(path_, *network_, small_lite());
    const std::string bytes = read_file(path_);
    for (const std::size_t length : {bytes.size() / 2, bytes.size() - 1, std::size_t{0}}) {
        write_file(path_, std::string_view(bytes).substr(0, length));
        EXPECT_TRUE(test::thrown_text([&] { (void)Checkpoint(path_).network(); }).starts_with(path_.string()))
            << length;
    }
}

}  // namespace
}  // namespace ddtool::train_torch

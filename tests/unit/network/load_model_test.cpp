#include "ddtool/network/load_model.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "dd_weights.hpp"
#include "ddtool/system/settings.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"

namespace ddtool::network {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr std::size_t size_px = 64;
constexpr std::size_t pixels = size_px * size_px;

class LoadModel : public testing::Test {
protected:
    void describe(const std::function<void(Json&)>& change) {
        Json about = Json::parse(file_.about);
        change(about);
        file_.about = about.dump();
    }
    network::NamedTensor& tensor(const std::string& name) {
        return *std::ranges::find(file_.tensors, name, &network::NamedTensor::name);
    }
    [[nodiscard]] std::unique_ptr<DegreeModel> loaded() const {
        network::write_safetensors(path_, file_);
        return load_model(path_);
    }
    [[nodiscard]] std::string error() const {
        return test::thrown_text([&] { (void)loaded(); });
    }
    [[nodiscard]] std::vector<double> degrees(const std::vector<float>& images) const {
        std::vector<double> result(images.size() / pixels);
        loaded()->run(images, result);
        return result;
    }

    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "model.safetensors";
    network::PlainWeights file_ = test::drawn_dd_model("ddmodel-lite", size_px);
};

std::vector<float> drawn_images(std::size_t count) {
    RandomStream random({15});
    std::vector<float> images(count * pixels);
    std::generate(images.begin(), images.end(), [&] { return random.uniform() < 0.1 ? 1.0F : 0.0F; });
    return images;
}

double logit(double degree) { return std::log(degree / (1.0 - degree)); }

TEST_F(LoadModel, RefusesAFileThatIsListedWithAnotherChecksum) {
    EXPECT_EQ(error(), "");
    write_file(folder_ / "SHA256SUMS", std::string(64, '0') + "  model.safetensors\n");
    EXPECT_THAT(error(), HasSubstr("model.safetensors: damaged or another file"));
}

TEST_F(LoadModel, GivesABatchTheDegreesOfItsImages) {
    const std::vector<float> images = drawn_images(3);
    const std::vector<double> together = degrees(images);
    for (std::size_t index = 0; index < together.size(); ++index) {
        const auto first = images.begin() + static_cast<std::ptrdiff_t>(index * pixels);
        EXPECT_EQ(degrees({first, first + pixels}), std::vector<double>{together[index]});
    }
    EXPECT_NE(together[0], together[1]);
}

TEST_F(LoadModel, DividesTheLogitByTheTemperature) {
    const double plain = logit(degrees(drawn_images(1)).front());
    describe([](Json& about) { about["temperature"] = 2.5; });
    EXPECT_NEAR(logit(degrees(drawn_images(1)).front()), plain / 2.5, 1e-9);
}

// With the loss "bce" the second output has no effect: the result is that of a softmax whose second logit is always 0.
TEST_F(LoadModel, TakesTheSigmoidOfOneOutputForBce) {
    const auto half = static_cast<std::ptrdiff_t>(tensor("head.weight").values.size() / 2);
    std::fill_n(tensor("head.weight").values.begin(), half, 0.0F);
    tensor("head.bias").values[0] = 0.0F;
    const double softmax = degrees(drawn_images(1)).front();
    tensor("head.bias").values[0] = 3.0F;
    EXPECT_NE(degrees(drawn_images(1)).front(), softmax);
    describe([](Json& about) { about["loss"] = "bce"; });
    EXPECT_EQ(degrees(drawn_images(1)).front(), softmax);
}

TEST_F(LoadModel, KeepsTheDescription) { EXPECT_EQ(Json(loaded()->description()), Json::parse(file_.about)); }

TEST_F(LoadModel, RefusesImagesOfAnotherSize) {
    std::vector<double> degree(1);
    const auto model = loaded();
    EXPECT_THAT(test::thrown_text([&] { model->run(std::vector<float>(pixels - 1), degree); }), HasSubstr("64 x 64"));
}

TEST_F(LoadModel, NamesAMissingTensor) {
    std::erase_if(file_.tensors, [](const auto& item) { return item.name == "groups.1.projection.norm.bias"; });
    EXPECT_THAT(error(), AllOf(StartsWith(path_.string()), HasSubstr("no tensor groups.1.projection.norm.bias")));
}

TEST_F(LoadModel, NamesATensorOfAnotherShape) {
    tensor("embedding.weight").shape = {32, 128};
    EXPECT_THAT(error(), AllOf(StartsWith(path_.string()), HasSubstr("embedding.weight"), HasSubstr("[32,128]"),
                               HasSubstr("[64,64]")));
}

TEST_F(LoadModel, NamesATensorThatHasNoPlace) {
    file_.tensors.push_back({"groups.3.first.conv.weight", {1}, {0.0F}});
    EXPECT_THAT(error(), AllOf(StartsWith(path_.string()), HasSubstr("groups.3.first.conv.weight")));
}

TEST_F(LoadModel, RefusesANetworkOfAnotherKind) {
    describe([](Json& about) { about["network"] = "mobilenetv3"; });
    EXPECT_THAT(error(), AllOf(StartsWith(path_.string()), HasSubstr("mobilenetv3"), HasSubstr("ddmodel-lite")));
}

TEST_F(LoadModel, RefusesABrokenDescription) {
    describe([](Json& about) { about["image"]["size_px"] = 0; });
    EXPECT_THAT(error(), AllOf(StartsWith(path_.string()), HasSubstr("size_px")));
    describe([](Json& about) { about["image"]["size_px"] = 4096; });
    EXPECT_THAT(error(), HasSubstr("position"));
    describe([](Json& about) { about["loss"] = "hinge"; });
    EXPECT_THAT(error(), HasSubstr("loss"));
    describe([](Json& about) { about = {{"loss", "bce"}, {"metrics", "x"}}; });
    EXPECT_THAT(error(), HasSubstr("description"));
    file_.about = "";
    EXPECT_THAT(error(), AllOf(StartsWith(path_.string()), HasSubstr("description")));
}

}  // namespace
}  // namespace ddtool::network

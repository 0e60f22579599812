#include "train/torch/exported_model.hpp"

#include <gmock/gmock.h>
#include <torch/script.h>

#include <cstdlib>
#include <fstream>

#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"
#include "thrown_text.hpp"
#include "train/torch/losses.hpp"
#include "used_network.hpp"

namespace ddtool::train_torch {
namespace {

void write_floats(const std::filesystem::path& path, const torch::Tensor& values) {
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(values.data_ptr<float>()), values.numel() * 4);
}

class ExportedModel : public testing::TestWithParam<std::string> {
protected:
    void export_with(const std::string& loss) {
        about_ = described(GetParam(), loss);
        write_torch_script(path_, *network_, about_);
    }
    [[nodiscard]] torch::Tensor values(const torch::Tensor& images) const {
        const torch::NoGradGuard no_gradients;
        return output_values(about_.loss, network_->forward(images) / about_.temperature);
    }

    std::shared_ptr<Network> network_ = used_network(GetParam());
    ModelDescription about_;
    test::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_ / "model.pt";
};

TEST_P(ExportedModel, AgreesWithTheNetworkForAnyBatch) {
    for (const char* loss : {"cross-entropy", "bce"}) {
        export_with(loss);
        const auto model = load_torch_script(path_, {});
        for (const std::int64_t count : {1, 2, 7, 64}) {
            const torch::Tensor images = drawn_images(count);
            const std::vector<double> degrees = degrees_by(*model, images);
            const torch::Tensor expected = values(images).select(1, degenerate_output);
            for (std::int64_t index = 0; index < count; ++index) {
                EXPECT_NEAR(degrees[static_cast<std::size_t>(index)], expected[index].item<double>(), 1e-5)
                    << loss << ", image " << index << " of " << count;
            }
            EXPECT_TRUE(count < 64 || differ(degrees));
        }
    }
}

TEST_P(ExportedModel, IsNearInBf16) {
    export_with("cross-entropy");
    const auto rounded = load_torch_script(path_, {.precision = "bf16"});
    const torch::Tensor images = drawn_images(7);
    const std::vector<double> degrees = degrees_by(*rounded, images);
    const std::vector<double> exact = degrees_by(*load_torch_script(path_, {}), images);
    EXPECT_NE(degrees, exact) << "bf16 did nothing";
    for (std::size_t index = 0; index < degrees.size(); ++index) {
        EXPECT_NEAR(degrees[index], exact[index], 0.05);
    }
}

TEST_P(ExportedModel, CarriesItsDescription) {
    export_with("bce");
    EXPECT_TRUE(is_exported_model(path_));
    EXPECT_EQ(Json(load_torch_script(path_, {})->description()), Json(about_));
}

TEST_P(ExportedModel, OpensInPythonAndAgrees) {
    export_with("cross-entropy");
    const torch::Tensor images = drawn_images(3);
    write_floats(folder_ / "images", images);
    write_floats(folder_ / "values", values(images).contiguous());
    const std::string command = std::string(DDTOOL_PYTHON " '" DDTOOL_OPEN_MODEL "' ") + path_.string() + " " +
                                (folder_ / "images").string() + " " + (folder_ / "values").string();
    EXPECT_EQ(std::system(command.c_str()), 0);
}

INSTANTIATE_TEST_SUITE_P(Networks, ExportedModel, testing::ValuesIn(network_names()), [](const auto& info) {
    std::string name = info.param;
    std::erase(name, '-');
    return name;
});

TEST(LoadTorchScript, NamesAFileThatIsNone) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "model.pt";
    EXPECT_THAT(test::thrown_text([&] { (void)is_exported_model(path); }), testing::StartsWith(path.string()));
    write_file(path, "no archive");
    EXPECT_THAT(test::thrown_text([&] { (void)is_exported_model(path); }), testing::StartsWith(path.string()));
    EXPECT_THAT(test::thrown_text([&] { (void)load_torch_script(path, {}); }), testing::StartsWith(path.string()));
}

/// Writes a module that contains a model's description, but any code.
void write_module(const std::filesystem::path& path, const std::string& forward) {
    torch::jit::Module module("Stranger");
    module.register_attribute("training", c10::BoolType::get(), false);
    module.define("def forward(self, images):\n" + forward + "\n");
    module.save(path.string(), {{"ddtool.json", Json(described("ddmodel-lite", "bce")).dump()}});
}

TEST(LoadTorchScript, NamesTheFileInOneLineWhenItsCodeFails) {
    const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / "model.pt";
    for (const char* forward : {"    return images", "    assert bool(images.sum() < 0)\n    return images"}) {
        write_module(path, forward);
        const std::string text =
            test::thrown_text([&] { (void)degrees_by(*load_torch_script(path, {}), drawn_images(2)); });
        EXPECT_THAT(text, testing::StartsWith(path.string() + ": not a TorchScript model of ddtool: ")) << forward;
        EXPECT_THAT(text, testing::Not(testing::HasSubstr("\n"))) << forward;
    }
}

}  // namespace
}  // namespace ddtool::train_torch

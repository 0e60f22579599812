#include "ddtool/network/load_model.hpp"

#include <cmath>

#include "ddtool/base/error.hpp"
#include "network/dd_network.hpp"
#include "system/atomic_file.hpp"
#include "system/checksums.hpp"

namespace ddtool {
namespace {

class NativeModel : public DegreeModel {
public:
    NativeModel(ModelDescription description, network::DDNetwork network)
        : description_(std::move(description)), network_(std::move(network)) {}

    [[nodiscard]] const ModelDescription& description() const override { return description_; }

    void run(std::span<const float> images, std::span<double> degrees) override {
        const std::size_t size_px = description_.image.size_px;
        const std::size_t pixels = size_px * size_px;
        if (images.size() != degrees.size() * pixels) {
            throw Error("a model for images of " + std::to_string(size_px) + " x " + std::to_string(size_px) +
                        " pixels was given others");
        }
        for (std::size_t index = 0; index < degrees.size(); ++index) {
            degrees[index] = degree(network_.run(images.subspan(index * pixels, pixels)));
        }
    }

private:
    /// The softmax of two logits is the sigmoid of their difference. With the loss "bce" only the logit of the output
    /// for degenerate counts.
    [[nodiscard]] double degree(const std::array<double, 2>& logits) const {
        const double other = description_.loss == "bce" ? 0.0 : logits[1 - degenerate_output];
        return 1.0 / (1.0 + std::exp((other - logits[degenerate_output]) / description_.temperature));
    }

    ModelDescription description_;
    network::DDNetwork network_;
};

const network::DDModelTable& table_of(const std::string& network) {
    const network::DDModelTable* const table = network::find_ddmodel_table(network);
    if (table == nullptr) {
        throw Error("holds the network " + network +
                    "; only ddmodel, ddmodel-lite and their variants run without LibTorch");
    }
    return *table;
}

}  // namespace

std::unique_ptr<DegreeModel> load_model(const std::filesystem::path& path) {
    expect_listed_checksum(path);
    return load_model(read_file(path), path.string());
}

std::unique_ptr<DegreeModel> load_model(std::string_view bytes, const std::string& name) {
    network::PlainWeights file = network::parse_safetensors(bytes, name);
    network::NamedWeights weights(std::move(file.tensors));
    ModelDescription description = parse_model_description(file.about, name);
    try {
        network::DDNetwork network(weights, table_of(description.network), description.image.size_px);
        weights.expect_all_taken();
        return std::make_unique<NativeModel>(std::move(description), std::move(network));
    } catch (const Error& error) {
        throw Error(name + ": " + error.what());
    }
}

}  // namespace ddtool

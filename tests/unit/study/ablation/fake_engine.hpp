#pragma once

#include <filesystem>
#include <fstream>
#include <functional>

#include "ddtool/base/error.hpp"
#include "swarm/rules.hpp"
#include "system/atomic_file.hpp"
#include "train/engine.hpp"

namespace ddtool::ablation::test {

/// Stands in for a network. Its degree for every image is 0.9 if the seed in its settings is 1, and 0.1 otherwise.
class BrightnessModel : public DegreeModel {
public:
    explicit BrightnessModel(const train::TrainSettings& settings) {
        description_.network = settings.model;
        description_.loss = settings.loss;
        description_.image = settings.image;
        description_.label = settings.label;
        description_.split = settings.split;
        description_.seed = settings.seed;
    }
    [[nodiscard]] const ModelDescription& description() const override { return description_; }
    void run(std::span<const float> images, std::span<double> degrees) override {
        seen.assign(images.begin(), images.end());
        std::fill(degrees.begin(), degrees.end(), description_.seed == 1 ? 0.9 : 0.1);
        ++runs;
    }

    std::vector<float> seen;
    std::size_t runs = 0;

private:
    ModelDescription description_;
};

/// "Trains" a network by writing down its settings, which is all that BrightnessModel needs.
class FakeEngine : public train::Engine {
public:
    [[nodiscard]] std::vector<std::string> networks() const override { return {"bright"}; }
    train::TrainResult train(const train::TrainRequest& request) const override {
        ++trainings;
        if (request.settings.model == "broken") {
            throw Error("no such network");
        }
        write_file(request.out / "best.pt", Json(request.settings).dump());
        train::TrainResult result;
        result.best = request.out / "best.pt";
        result.interrupted = stop;
        return result;
    }
    void export_model(const std::filesystem::path& checkpoint, const std::filesystem::path& out) const override {
        std::filesystem::copy_file(checkpoint, out, std::filesystem::copy_options::overwrite_existing);
    }
    [[nodiscard]] std::unique_ptr<DegreeModel> load(const std::filesystem::path& file,
                                                    const train::RunOptions& options) const override {
        if (options.device != "cpu") {
            throw Error("there is no " + options.device);
        }
        return std::make_unique<BrightnessModel>(Json::parse(read_file(file)).get<train::TrainSettings>());
    }
    [[nodiscard]] ModelDescription describe(const std::filesystem::path& file) const override {
        return load(file, {})->description();
    }

    mutable std::size_t trainings = 0;
    bool stop = false;
};

}  // namespace ddtool::ablation::test

#include "train/torch/torch_engine.hpp"

#include "ddtool/base/error.hpp"
#include "system/log.hpp"
#include "train/process_group.hpp"
#include "train/torch/exported_model.hpp"
#include "train/torch/losses.hpp"
#include "train/torch/torch_model.hpp"
#include "train/torch/trainer.hpp"

namespace ddtool::train_torch {
namespace {

void expect_device(const std::string& device) {
    if (device != "cpu" && !device.starts_with("cuda")) {
        throw UsageError("device: expected cpu or cuda, not " + device);
    }
    if (device != "cpu" && !torch::cuda::is_available()) {
        throw UsageError("device: " + device +
                         " is not there, or this LibTorch (" TORCH_VERSION ") was built without CUDA");
    }
}

std::unique_ptr<DegreeModel> model_of(Checkpoint& checkpoint, const train::RunOptions& options) {
    const std::shared_ptr<Network> network = checkpoint.network();
    ModelDescription about = checkpoint.description();
    const torch::Device device(options.device);
    network->to(device);
    const auto forward = [network, loss = about.loss, temperature = about.temperature](const torch::Tensor& images) {
        return output_values(loss, network->forward(images) / temperature);
    };
    return std::make_unique<TorchModel>(std::move(about), forward, options);
}

class TorchEngine : public train::Engine {
public:
    [[nodiscard]] std::vector<std::string> networks() const override { return network_names(); }

    train::TrainResult train(const train::TrainRequest& request) const override {
        expect_valid(request.settings);
        expect_device(request.device);
        const std::optional<train::ProcessGroup> group = train::process_group();
        train::TrainRequest own = request;
        if (group && request.device == "cuda") {
            // Some launchers make a single GPU visible to each process, hence the modulo.
            const auto gpus = static_cast<std::size_t>(torch::cuda::device_count());
            own.device = "cuda:" + std::to_string(group->local_rank % gpus);
        }
        if (group && group->rank.rank > 0) {
            set_log_level(LogLevel::error);
        }
        if (request.threads > 0) {
            at::set_num_threads(static_cast<int>(request.threads));
        }
        // Denormal numbers make some processors many times slower, and they are too small to matter here.
        at::globalContext().setFlushDenormal(true);
        const torch::Device device(own.device);
        // Without the guard, every operation that does not name a device would allocate memory on the first GPU, in
        // every process.
        const c10::DeviceGuard guard(device);
        const Communicator communicator(group, device);
        train::TrainResult result = Trainer(own, communicator).run();
        result.leads = communicator.leads();
        return result;
    }

    void export_model(const std::filesystem::path& checkpoint, const std::filesystem::path& out) const override {
        Checkpoint source(checkpoint);
        const ModelDescription about = source.description();
        const std::shared_ptr<Network> network = source.network();
        write_torch_script(out, *network, about);
        network::write_safetensors(train::plain_weights_beside(out), plain_weights(*network, about));
    }

    [[nodiscard]] std::unique_ptr<DegreeModel> load(const std::filesystem::path& file,
                                                    const train::RunOptions& options) const override {
        expect_device(options.device);
        if (is_exported_model(file)) {
            return load_torch_script(file, options);
        }
        Checkpoint checkpoint(file);
        return model_of(checkpoint, options);
    }

    [[nodiscard]] ModelDescription describe(const std::filesystem::path& file) const override {
        return is_exported_model(file) ? description_of_torch_script(file) : Checkpoint(file).description();
    }
};

}  // namespace

const train::Engine& torch_engine() {
    static const TorchEngine engine;
    return engine;
}

}  // namespace ddtool::train_torch

#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "ddtool/network/degree_model.hpp"
#include "train/history.hpp"
#include "train/train_settings.hpp"

namespace ddtool::train {

struct TrainRequest {
    std::filesystem::path data;  ///< folder of a data set
    std::filesystem::path out;   ///< folder for checkpoints and metrics
    TrainSettings settings;
    std::string device = "cpu";  ///< cpu or cuda
    std::size_t threads = 0;     ///< threads for the computation; 0 stands for all cores
    bool resume = false;  ///< continues from out/last.pt; if there is none, the training starts from the beginning
    double checkpoint_interval_s = 300.0;  ///< last.pt is written at least this often, and after every epoch
};

struct TrainResult {
    std::filesystem::path best;  ///< checkpoint
    EpochRecord best_epoch;
    std::size_t epochs = 0;
    bool interrupted = false;  ///< the training was asked to stop, and last.pt can be resumed
    bool leads = true;         ///< false on the ranks of a distributed training that write nothing
};

struct RunOptions {
    std::string device = "cpu";
    std::string precision = "fp32";  ///< or bf16
    std::size_t threads = 1;
};

/// The path to which the plain weights of the exported model are written.
inline std::filesystem::path plain_weights_beside(std::filesystem::path model) {
    return model.replace_extension(".safetensors");
}

/// Everything that needs LibTorch. Loading LibTorch costs half a second and 160 MB when a program starts, which
/// commands without networks should not pay. Therefore it is in a program of its own, ddtool-torch
/// (docs/architecture.md).
class Engine {
public:
    virtual ~Engine() = default;
    /// Names of the networks that can be trained.
    [[nodiscard]] virtual std::vector<std::string> networks() const = 0;
    virtual TrainResult train(const TrainRequest& request) const = 0;
    /// Writes the checkpoint's network as TorchScript, with its description inside, and its plain weights to
    /// plain_weights_beside(out) (docs/formats/model.md).
    virtual void export_model(const std::filesystem::path& checkpoint, const std::filesystem::path& out) const = 0;
    /// Loads an exported model or a checkpoint. Throws Error naming the file and what is wrong with it.
    [[nodiscard]] virtual std::unique_ptr<DegreeModel> load(const std::filesystem::path& file,
                                                            const RunOptions& options) const = 0;
    /// What such a file says of its network, without making the network ready to run. Throws Error as load() does.
    [[nodiscard]] virtual ModelDescription describe(const std::filesystem::path& file) const = 0;
};

/// Provides the engine; main() sets it. It may start another program in place of this one.
using EngineProvider = const Engine& (*)();
void set_engine_provider(EngineProvider provider);

/// Returns the engine. Call this before the command prints or writes anything, because the provider may start the
/// command anew in another program. Throws Error if there is no provider.
const Engine& engine();

}  // namespace ddtool::train

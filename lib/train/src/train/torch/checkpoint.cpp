#include "train/torch/checkpoint.hpp"

#include <ATen/CPUGeneratorImpl.h>
#include <algorithm>
#include <sstream>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"
#include "train/torch/torch_errors.hpp"

namespace ddtool::train_torch {
namespace {

constexpr const char* description_key = "description";
constexpr const char* state_key = "state";
constexpr const char* network_key = "network";
constexpr const char* optimizer_key = "optimizer";
constexpr const char* random_key = "random_state";

void put_network(torch::serialize::OutputArchive& archive, const Network& network,
                 const ModelDescription& description) {
    archive.write(description_key, torch::IValue(Json(description).dump()));
    torch::serialize::OutputArchive weights(archive.compilation_unit());
    network.save(weights);
    archive.write(network_key, weights);
}

void write_archive(const std::filesystem::path& path, torch::serialize::OutputArchive& archive) {
    std::ostringstream bytes;
    archive.save_to(bytes);
    write_file(path, bytes.view());
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Network& network, const ModelDescription& description) {
    torch::serialize::OutputArchive archive;
    put_network(archive, network, description);
    write_archive(path, archive);
}

void write_checkpoint(const std::filesystem::path& path, const Network& network, const ModelDescription& description,
                      const torch::optim::Optimizer& optimizer, const train::TrainingState& state) {
    torch::serialize::OutputArchive archive;
    put_network(archive, network, description);
    archive.write(state_key, torch::IValue(Json(state).dump()));
    torch::serialize::OutputArchive moments(archive.compilation_unit());
    optimizer.save(moments);
    archive.write(optimizer_key, moments);
    archive.write(random_key, at::detail::getDefaultCPUGenerator().get_state());
    write_archive(path, archive);
}

template <typename Action>
auto Checkpoint::guarded(Action&& action) {
    return guarded_by_path(path_, "not a whole checkpoint", action);
}

Checkpoint::Checkpoint(const std::filesystem::path& path, torch::Device device) : path_(path) {
    const std::string bytes = read_file(path);
    guarded([&] { archive_.load_from(bytes.data(), bytes.size(), device); });
}

std::string Checkpoint::text(const char* key) {
    torch::IValue value;
    if (!guarded([&] { return archive_.try_read(key, value) && value.isString(); })) {
        throw Error(path_.string() + ": no " + key + " in this checkpoint");
    }
    return value.toStringRef();
}

ModelDescription Checkpoint::description() { return parse_model_description(text(description_key), path_.string()); }

std::shared_ptr<Network> Checkpoint::network() {
    const ModelDescription about = description();
    std::shared_ptr<Network> network = make_network(about.network, about.image.size_px);
    guarded([&] {
        torch::serialize::InputArchive weights;
        archive_.read(network_key, weights);
        network->load(weights);
    });
    network->eval();
    return network;
}

train::TrainingState Checkpoint::state() {
    const std::string state = text(state_key);
    return guarded([&] { return parse_json(state, path_.string()).get<train::TrainingState>(); });
}

void Checkpoint::restore(Network& network, torch::optim::Optimizer& optimizer) {
    guarded([&] {
        torch::serialize::InputArchive weights;
        archive_.read(network_key, weights);
        network.load(weights);
        torch::serialize::InputArchive moments;
        archive_.read(optimizer_key, moments);
        optimizer.load(moments);
        torch::Tensor random;
        archive_.read(random_key, random);
        at::Generator generator = at::detail::getDefaultCPUGenerator();
        const std::lock_guard lock(generator.mutex());
        generator.set_state(random.to(torch::kCPU));
    });
}

}  // namespace ddtool::train_torch

#include "train/torch/exported_model.hpp"

#include <caffe2/serialize/inline_container.h>
#include <torch/csrc/jit/frontend/tracer.h>
#include <torch/script.h>
#include <sstream>

#include "ddtool/base/error.hpp"
#include "system/atomic_file.hpp"
#include "system/checksums.hpp"
#include "train/torch/losses.hpp"
#include "train/torch/torch_errors.hpp"
#include "train/torch/torch_model.hpp"

namespace ddtool::train_torch {
namespace {

constexpr const char* description_file = "ddtool.json";

/// A TorchScript module with the structure of the network. It shares the network's tensors and does not copy them.
torch::jit::Module owner_of(const torch::nn::Module& network, const std::string& name,
                            const std::shared_ptr<torch::jit::CompilationUnit>& unit) {
    // The prefix is needed because the children of a Sequential have numbers as names, and the name of a class may not
    // be a number.
    torch::jit::Module owner(c10::QualifiedName("__torch__.layer_" + name), unit, /*shouldMangle=*/true);
    for (const auto& parameter : network.named_parameters(/*recurse=*/false)) {
        owner.register_parameter(parameter.key(), parameter.value(), /*is_buffer=*/false);
    }
    for (const auto& buffer : network.named_buffers(/*recurse=*/false)) {
        owner.register_buffer(buffer.key(), buffer.value());
    }
    for (const auto& child : network.named_children()) {
        owner.register_module(child.key(), owner_of(*child.value(), child.key(), unit));
    }
    owner.register_attribute("training", c10::BoolType::get(), false);
    return owner;
}

/// Traces the network with a batch and adds the recorded graph to `owner` as the method "forward".
void trace_forward(torch::jit::Module& owner, Network& network, const ModelDescription& description) {
    const auto size = static_cast<std::int64_t>(description.image.size_px);
    // The batch has two images: with one, an operation that works only for a batch of one would go unnoticed.
    const torch::Tensor images = torch::zeros({2, 1, size, size}, network.parameters().front().options());
    const auto forward = [&](torch::jit::Stack inputs) -> torch::jit::Stack {
        const torch::Tensor logits = network.forward(inputs.at(0).toTensor()) / description.temperature;
        return {output_values(description.loss, logits)};
    };
    const auto traced = torch::jit::tracer::trace(
        {images}, forward, [](const torch::autograd::Variable&) { return std::string(); }, /*strict=*/true,
        /*force_outplace=*/false, &owner, {"images"});
    const c10::QualifiedName name(*owner.type()->name(), "forward");
    owner.type()->addMethod(owner._ivalue()->compilation_unit()->create_function(name, traced.first->graph));
}

/// The text of this extra file of the archive, empty if there is none. Every archive of LibTorch is a zip file, so that
/// the rest of it need not be read.
std::string extra_text(const std::filesystem::path& path, const std::string& name) {
    caffe2::serialize::PyTorchStreamReader reader(path.string());
    const std::string record = "extra/" + name;
    if (!reader.hasRecord(record)) {
        return "";
    }
    const auto [bytes, size] = reader.getRecord(record);
    return {static_cast<const char*>(bytes.get()), size};
}

ModelDescription description_in(const std::string& text, const std::filesystem::path& path) {
    if (text.empty()) {
        throw Error(path.string() + ": not a model of ddtool: no " + description_file + " inside");
    }
    return parse_model_description(text, path.string());
}

/// Prepares a loaded module for inference in one precision. The result ignores autocast, and LibTorch 1.13 cannot save
/// it. optimize_for_inference() folds batch normalisation into the convolutions and changes the layout of the weights
/// to suit the processor. Networks with hard swish or hard sigmoid are only frozen, which folds batch normalisation,
/// too: LibTorch 1.13 applies these functions to the padding of such layouts as well, which made an error of 0.4 in the
/// degree of a MobileNetV3.
torch::jit::Module made_ready(torch::jit::Module module) {
    const std::string code = module.get_method("forward").graph()->toString(/*print_source_locations=*/false);
    return code.find("aten::hard") == std::string::npos ? torch::jit::optimize_for_inference(module)
                                                        : torch::jit::freeze(module);
}

torch::Tensor class_values(torch::Tensor values) {
    if (values.dim() != 2 || values.size(1) != 2) {
        throw std::runtime_error("it answers with other than two values an image");
    }
    return values;
}

}  // namespace

void write_torch_script(const std::filesystem::path& path, Network& network, const ModelDescription& description) {
    network.eval();
    const torch::NoGradGuard no_gradients;
    torch::jit::Module owner = owner_of(network, "network", std::make_shared<torch::jit::CompilationUnit>());
    trace_forward(owner, network, description);
    std::ostringstream bytes;
    owner.save(bytes, {{description_file, Json(description).dump(2)}});
    write_file(path, bytes.view());
}

bool is_exported_model(const std::filesystem::path& path) {
    if (!std::filesystem::is_regular_file(path)) {
        throw Error(path.string() + ": no such file; expected a model of ddtool export, or a checkpoint");
    }
    return guarded_by_path(path, "neither a TorchScript model nor a checkpoint, or cut short",
                           [&] { return !extra_text(path, description_file).empty(); });
}

ModelDescription description_of_torch_script(const std::filesystem::path& path) {
    const std::string text =
        guarded_by_path(path, "not a TorchScript model of ddtool", [&] { return extra_text(path, description_file); });
    return description_in(text, path);
}

std::unique_ptr<DegreeModel> load_torch_script(const std::filesystem::path& path, const train::RunOptions& options) {
    expect_listed_checksum(path);
    torch::jit::ExtraFilesMap extra{{description_file, ""}};
    const auto guarded = [path](auto&& action) {
        return guarded_by_path(path, "not a TorchScript model of ddtool", action);
    };
    torch::jit::Module module =
        guarded([&] { return torch::jit::load(path.string(), torch::Device(options.device), extra); });
    ModelDescription description = description_in(extra.at(description_file), path);
    guarded([&] {
        module.eval();
        if (options.precision == "fp32") {
            module = made_ready(std::move(module));
        }
    });
    return std::make_unique<TorchModel>(
        std::move(description),
        [module, guarded](const torch::Tensor& images) mutable {
            return guarded([&] { return class_values(module.forward({images}).toTensor()); });
        },
        options);
}

network::PlainWeights plain_weights(const Network& network, const ModelDescription& about) {
    network::PlainWeights weights{Json(about).dump(), {}};
    const auto add = [&](const auto& items) {
        for (const auto& item : items) {
            const torch::Tensor values = item.value().detach().to(torch::kCPU, torch::kFloat32).contiguous();
            weights.tensors.push_back({item.key(),
                                       values.sizes().vec(),
                                       {values.data_ptr<float>(), values.data_ptr<float>() + values.numel()}});
        }
    };
    add(network.named_parameters());
    add(network.named_buffers());
    return weights;
}

}  // namespace ddtool::train_torch

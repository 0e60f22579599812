#include "train/torch/communicator.hpp"

#include <torch/csrc/autograd/custom_function.h>
#include <torch/csrc/distributed/c10d/PrefixStore.hpp>
#include <torch/csrc/distributed/c10d/ProcessGroupGloo.hpp>
#include <torch/csrc/distributed/c10d/TCPStore.hpp>
#ifdef USE_C10D_NCCL
#include <torch/csrc/distributed/c10d/ProcessGroupNCCL.hpp>
#endif

#include <chrono>

#include "ddtool/base/error.hpp"
#include "train/torch/batch_norm.hpp"

namespace ddtool::train_torch {
namespace {

/// How long a rank waits for the others at the start. A rank that is lost later is noticed at once, because its
/// connection breaks.
constexpr std::chrono::minutes patience_to_meet{5};
/// How long a collective operation may take. The limit is generous, because all other ranks wait in one while rank 0
/// validates.
constexpr std::chrono::minutes patience{30};

/// Whether a store exists already: torchrun runs one at the master's address, which all ranks then use.
bool store_is_hosted() { return train::process_environment("TORCHELASTIC_USE_AGENT_STORE") == "True"; }

template <typename Action>
void with_others(const char* what, Action&& action) {
    try {
        action();
    } catch (const std::exception& error) {
        const std::string reason = error.what();
        throw Error(std::string(what) + ": another rank was lost or cannot be reached: " +
                    reason.substr(0, reason.find('\n')) + "; start all ranks again with --resume");
    }
}

}  // namespace

/// The store through which the ranks find each other, and the collective operations.
class Communicator::Group {
public:
    Group(const train::ProcessGroup& group, [[maybe_unused]] torch::Device device) {
        c10d::TCPStoreOptions options;
        options.port = group.master_port;
        options.isServer = group.rank.rank == 0 && !store_is_hosted();
        options.numWorkers = group.rank.world_size;
        options.waitWorkers = !store_is_hosted();
        options.timeout = patience_to_meet;
#if TORCH_VERSION_MAJOR > 2 || (TORCH_VERSION_MAJOR == 2 && TORCH_VERSION_MINOR >= 4)
        // The default (true) needs libuv, without which some builds of LibTorch are made. Both servers use the same
        // protocol.
        options.useLibUV = false;
#endif
        const auto meeting = c10::make_intrusive<c10d::TCPStore>(group.master_address, options);
        const auto store = c10::make_intrusive<c10d::PrefixStore>("ddtool", meeting);
        const auto rank = static_cast<int>(group.rank.rank);
        const auto size = static_cast<int>(group.rank.world_size);
#ifdef USE_C10D_NCCL
        if (device.is_cuda()) {
            const auto nccl = c10d::ProcessGroupNCCL::Options::create();
            nccl->timeout = patience;
            backend_ = c10::make_intrusive<c10d::ProcessGroupNCCL>(store, rank, size, nccl);
            return;
        }
#endif
        const auto gloo = c10d::ProcessGroupGloo::Options::create(patience);
        gloo->devices.push_back(c10d::ProcessGroupGloo::createDefaultDevice());
        backend_ = c10::make_intrusive<c10d::ProcessGroupGloo>(store, rank, size, gloo);
    }

    void sum(torch::Tensor& tensor) {
        std::vector<torch::Tensor> tensors{tensor};
        backend_->allreduce(tensors)->wait();
    }

    void broadcast(torch::Tensor& tensor) {
        std::vector<torch::Tensor> tensors{tensor};
        backend_->broadcast(tensors)->wait();
    }

private:
#if TORCH_VERSION_MAJOR >= 2
    c10::intrusive_ptr<c10d::Backend> backend_;
#else
    c10::intrusive_ptr<c10d::ProcessGroup> backend_;
#endif
};

namespace {

using Sum = std::function<void(torch::Tensor&)>;

/// The sum over the ranks, with a gradient. The values of one rank enter the losses of all ranks, so the gradient is
/// summed over the ranks as well.
struct SumOverRanksFunction : torch::autograd::Function<SumOverRanksFunction> {
    static torch::Tensor forward(torch::autograd::AutogradContext* context, const torch::Tensor& values,
                                 std::int64_t sum_address) {
        context->saved_data["sum"] = sum_address;
        return summed(values, sum_address);
    }

    static torch::autograd::variable_list backward(torch::autograd::AutogradContext* context,
                                                   torch::autograd::variable_list gradients) {
        return {summed(gradients[0], context->saved_data["sum"].toInt()), torch::Tensor()};
    }

    static torch::Tensor summed(const torch::Tensor& values, std::int64_t sum_address) {
        torch::Tensor result = values.contiguous().clone();
        // The sum is passed as an address, because an autograd context stores only numbers and tensors.
        (*reinterpret_cast<const Sum*>(sum_address))(result);
        return result;
    }
};

}  // namespace

Communicator::Communicator(const std::optional<train::ProcessGroup>& group, torch::Device device) : device_(device) {
    if (group) {
        rank_ = group->rank;
        with_others("meeting the other ranks", [&] { group_ = std::make_shared<Group>(*group, device); });
    }
}

Communicator::~Communicator() = default;

void Communicator::add_up(torch::Tensor& tensor) const {
    with_others("adding up over the ranks", [&] { group_->sum(tensor); });
}

void Communicator::copy_from_leader(std::vector<torch::Tensor> tensors) const {
    if (group_) {
        const torch::NoGradGuard no_gradients;
        for (torch::Tensor& tensor : tensors) {
            torch::Tensor values = tensor.contiguous();
            with_others("copying from rank 0", [&] { group_->broadcast(values); });
            tensor.copy_(values);
        }
    }
}

void Communicator::average_gradients(const std::vector<torch::Tensor>& parameters) const {
    if (!group_) {
        return;
    }
    std::vector<torch::Tensor> flat;
    for (const torch::Tensor& parameter : parameters) {
        flat.push_back(parameter.grad().reshape({-1}));
    }
    torch::Tensor all = torch::cat(flat);
    add_up(all);
    all /= static_cast<double>(rank_.world_size);
    std::int64_t first = 0;
    for (const torch::Tensor& parameter : parameters) {
        torch::Tensor gradient = parameter.grad();
        gradient.copy_(all.narrow(0, first, gradient.numel()).reshape(gradient.sizes()));
        first += gradient.numel();
    }
}

std::vector<double> Communicator::sums(const std::vector<double>& values) const {
    if (!group_) {
        return values;
    }
    torch::Tensor tensor = torch::tensor(values, torch::kFloat64).to(device_);
    add_up(tensor);
    tensor = tensor.to(torch::kCPU);
    return {tensor.data_ptr<double>(), tensor.data_ptr<double>() + tensor.numel()};
}

std::vector<double> Communicator::of_leader(const std::vector<double>& values) const {
    return sums(leads() ? values : std::vector<double>(values.size(), 0.0));
}

void Communicator::join_statistics(Network& network) const {
    if (group_) {
        // The hook below holds this object, so the address that it passes on stays valid.
        const auto sum = std::make_shared<const Sum>([group = group_](torch::Tensor& tensor) {
            with_others("adding up over the ranks", [&] { group->sum(tensor); });
        });
        set_sum_over_ranks(network, [sum](const torch::Tensor& values) {
            return SumOverRanksFunction::apply(values, reinterpret_cast<std::int64_t>(sum.get()));
        });
    }
}

}  // namespace ddtool::train_torch

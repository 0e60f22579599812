#include "train/process_group.hpp"

#include <charconv>
#include <cstdlib>
#include <limits>

#include "ddtool/base/error.hpp"

namespace ddtool::train {
namespace {

constexpr std::uint64_t most_processes = 1U << 20U;
constexpr std::uint64_t highest_port = std::numeric_limits<std::uint16_t>::max();
constexpr const char* usual_port = "29500";  ///< the default of PyTorch

/// The environment variables through which a launcher tells each process its place.
struct Launcher {
    const char* name;
    const char* rank;
    const char* world_size;
    const char* local_rank;
};
constexpr Launcher torchrun{"torchrun", "RANK", "WORLD_SIZE", "LOCAL_RANK"};
constexpr Launcher open_mpi{"Open MPI", "OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_LOCAL_RANK"};
/// The number of processes is not read from SLURM_NTASKS: it is also set in a batch script and in an interactive shell
/// (with a SLURM_PROCID of 0), although each of these is one process. Only srun sets the variables of a step.
constexpr Launcher slurm{"Slurm", "SLURM_PROCID", "SLURM_STEP_NUM_TASKS", "SLURM_LOCALID"};

[[noreturn]] void throw_unexpected(const std::string& variable, const std::string& expected, const std::string& value) {
    throw UsageError("environment: " + variable + ": expected " + expected + ", not '" + value + "'");
}

std::uint64_t number_in(const std::string& variable, const std::string& text, std::uint64_t least, std::uint64_t most) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < least || number > most) {
        throw_unexpected(variable, "a whole number, " + std::to_string(least) + " to " + std::to_string(most), text);
    }
    return number;
}

/// Reads the environment variables that one launcher has set.
class Launch {
public:
    Launch(const Launcher& launcher, const Environment& environment) : launcher_(launcher), environment_(environment) {}

    [[nodiscard]] std::string text(const std::string& variable) const {
        const std::optional<std::string> value = environment_(variable);
        if (!value) {
            throw UsageError("environment: " + variable + " is not set, though other variables of " + launcher_.name +
                             " are; start with it, or set them all");
        }
        return *value;
    }

    [[nodiscard]] std::uint64_t number(const std::string& variable, std::uint64_t least, std::uint64_t most) const {
        return number_in(variable, text(variable), least, most);
    }

    /// The process group, or nothing if this is the only process.
    [[nodiscard]] std::optional<ProcessGroup> group() const {
        ProcessGroup group;
        group.rank.world_size = number(launcher_.world_size, 1, most_processes);
        group.rank.rank = number(launcher_.rank, 0, group.rank.world_size - 1);
        group.local_rank = number(launcher_.local_rank, 0, group.rank.world_size - 1);
        return group.rank.world_size > 1 ? std::optional(group) : std::nullopt;
    }

private:
    const Launcher& launcher_;
    const Environment& environment_;
};

std::uint16_t port_in(const std::string& variable, const std::string& text) {
    return static_cast<std::uint16_t>(number_in(variable, text, 1, highest_port));
}

std::optional<ProcessGroup> torchrun_group(const Environment& environment) {
    const Launch launch(torchrun, environment);
    std::optional<ProcessGroup> group = launch.group();
    if (group) {
        group->master_address = launch.text("MASTER_ADDR");
        group->master_port = port_in("MASTER_PORT", launch.text("MASTER_PORT"));
    }
    return group;
}

/// mpirun does not tell its processes an address that all of them can reach. On one machine the loopback address will
/// do; otherwise MASTER_ADDR must be set.
std::optional<ProcessGroup> open_mpi_group(const Environment& environment) {
    const Launch launch(open_mpi, environment);
    std::optional<ProcessGroup> group = launch.group();
    if (group) {
        const std::optional<std::string> address = environment("MASTER_ADDR");
        const bool one_machine =
            launch.number("OMPI_COMM_WORLD_LOCAL_SIZE", 1, most_processes) == group->rank.world_size;
        group->master_address = !address && one_machine ? "127.0.0.1" : launch.text("MASTER_ADDR");
        group->master_port = port_in("MASTER_PORT", environment("MASTER_PORT").value_or(usual_port));
    }
    return group;
}

/// A port that depends on the job's number, so that two jobs on one machine do not use the same port.
std::uint16_t port_of_job(const Launch& launch) {
    constexpr std::uint64_t first = 20'000;
    constexpr std::uint64_t ports = 10'000;
    const std::uint64_t job = launch.number("SLURM_JOB_ID", 0, std::numeric_limits<std::uint64_t>::max());
    return static_cast<std::uint16_t>(first + job % ports);
}

std::optional<ProcessGroup> slurm_group(const Environment& environment) {
    const Launch launch(slurm, environment);
    std::optional<ProcessGroup> group = launch.group();
    if (group) {
        const std::optional<std::string> address = environment("MASTER_ADDR");
        const std::optional<std::string> port = environment("MASTER_PORT");
        group->master_address = address ? *address : first_host(launch.text("SLURM_STEP_NODELIST"));
        group->master_port = port ? port_in("MASTER_PORT", *port) : port_of_job(launch);
    }
    return group;
}

}  // namespace

std::optional<std::string> process_environment(const std::string& name) {
    const char* const value = std::getenv(name.c_str());
    return value == nullptr || *value == '\0' ? std::nullopt : std::optional<std::string>(value);
}

std::optional<ProcessGroup> process_group(const Environment& environment) {
    if (environment(torchrun.rank) || environment(torchrun.world_size) || environment(torchrun.local_rank)) {
        return torchrun_group(environment);
    }
    if (environment(open_mpi.rank) || environment(open_mpi.world_size)) {
        return open_mpi_group(environment);
    }
    return environment(slurm.world_size) ? slurm_group(environment) : std::nullopt;
}

std::string first_host(const std::string& node_list) {
    std::string host;
    for (std::size_t at = 0; at < node_list.size() && node_list[at] != ','; ++at) {
        if (node_list[at] != '[') {
            host += node_list[at];
            continue;
        }
        const std::size_t close = node_list.find(']', at);
        if (close == std::string::npos) {
            throw_unexpected("SLURM_STEP_NODELIST", "a ']' for every '['", node_list);
        }
        host += node_list.substr(at + 1, node_list.find_first_of("-,]", at) - at - 1);
        at = close;
    }
    return host;
}

}  // namespace ddtool::train

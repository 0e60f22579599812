#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "train/sampler.hpp"

namespace ddtool::train {

/// The processes that train one network together, as seen by one of them.
struct ProcessGroup {
    Rank rank;
    std::size_t local_rank = 0;  ///< the rank among the processes on this machine, which decides the GPU
    std::string master_address;  ///< the address of rank 0, at which the ranks meet
    std::uint16_t master_port = 0;
};

/// Returns the value of an environment variable, or nullopt if it is not set or empty.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// The environment of this process.
std::optional<std::string> process_environment(const std::string& name);

/// The group that a launcher has set up: torchrun, otherwise Open MPI, otherwise Slurm's srun (docs/training.md lists
/// the variables). srun comes last because it can start the other two, and the launcher nearest to the process counts.
/// Returns nullopt without a launcher and for a single process. Throws UsageError naming the variable that is missing
/// or invalid.
std::optional<ProcessGroup> process_group(const Environment& environment = process_environment);

/// The first host of a Slurm node list, such as "rack[2-3]node[01,07-09],login" -> "rack2node01".
std::string first_host(const std::string& node_list);

}  // namespace ddtool::train

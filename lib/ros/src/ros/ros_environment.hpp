#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ddtool {

/// Which robots can be met, as the environment of a ROS 2 program says it.
struct RosEnvironment {
    std::uint32_t domain = 0;
    bool loopback_only = false;      ///< only programs on this machine
    std::vector<std::string> peers;  ///< addresses that are asked, too, beside those that hear a multicast
    std::size_t gid_bytes = 16;      ///< of a GID in ros_discovery_info: 24 before Iron, 16 since
};

/// Reads ROS_DOMAIN_ID, ROS_LOCALHOST_ONLY, which has precedence over ROS_AUTOMATIC_DISCOVERY_RANGE, ROS_STATIC_PEERS
/// and ROS_DISTRO. Throws UsageError that names the variable and what was expected.
/// \param variable returns the value of the variable, or nullptr if it is not set, as std::getenv does
RosEnvironment ros_environment(const std::function<const char*(const char*)>& variable);

}  // namespace ddtool

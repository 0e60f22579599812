#include "ros/ros_environment.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <string_view>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

/// The ports of a larger number would lie above 65535 (DDSI-RTPS 2.3, 9.6.1.1).
constexpr std::uint32_t highest_domain = 232;

std::uint32_t domain_in(std::string_view text) {
    std::uint32_t domain = 0;
    const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), domain);
    if (fault != std::errc{} || end != text.data() + text.size() || domain > highest_domain) {
        throw UsageError("ROS_DOMAIN_ID=" + std::string(text) + ": expected a number from 0 to 232");
    }
    return domain;
}

std::vector<std::string> peers_in(std::string_view text) {
    std::vector<std::string> peers;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(';'), text.size());
        if (end > 0) {
            peers.emplace_back(text.substr(0, end));
        }
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return peers;
}

}  // namespace

RosEnvironment ros_environment(const std::function<const char*(const char*)>& variable) {
    const auto value = [&](const char* name) -> std::string_view {
        const char* const text = variable(name);
        return text == nullptr ? std::string_view{} : text;
    };
    RosEnvironment environment;
    if (const std::string_view domain = value("ROS_DOMAIN_ID"); !domain.empty()) {
        environment.domain = domain_in(domain);
    }
    const std::string_view range = value("ROS_AUTOMATIC_DISCOVERY_RANGE");
    if (value("ROS_LOCALHOST_ONLY") == "1") {
        environment.loopback_only = true;
    } else {
        if (range == "OFF") {
            throw UsageError("ROS_AUTOMATIC_DISCOVERY_RANGE=OFF: no robot can be found; expected SUBNET or LOCALHOST");
        }
        constexpr std::array<std::string_view, 4> known{"", "SUBNET", "LOCALHOST", "SYSTEM_DEFAULT"};
        if (std::ranges::count(known, range) == 0) {
            throw UsageError("ROS_AUTOMATIC_DISCOVERY_RANGE=" + std::string(range) +
                             ": expected SUBNET, LOCALHOST, SYSTEM_DEFAULT or OFF");
        }
        environment.peers = peers_in(value("ROS_STATIC_PEERS"));
        environment.loopback_only = range == "LOCALHOST" && environment.peers.empty();
    }
    constexpr std::array<std::string_view, 8> before_iron{"ardent",   "bouncy", "crystal",  "dashing",
                                                          "eloquent", "foxy",   "galactic", "humble"};
    const std::string_view distribution = value("ROS_DISTRO");
    environment.gid_bytes = !distribution.empty() && std::ranges::count(before_iron, distribution) > 0 ? 24 : 16;
    return environment;
}

}  // namespace ddtool

#include "engine_provider.hpp"
#include "robot_provider.hpp"
#include "ros/ros_link.hpp"

namespace ddtool {

std::unique_ptr<RobotLink> join_robot(const std::vector<std::string>& arguments) { return join_ros(arguments); }

/// ddtool-torch has no robots, so that it is not started from here.
const train::Engine& provide_engine() {
    throw Error(
        "--ros: a detector that needs LibTorch cannot be used on a robot; expected a rule, or a network in the "
        "form of .safetensors, which needs no LibTorch");
}

}  // namespace ddtool

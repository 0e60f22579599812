#include "other_program.hpp"
#include "robot_provider.hpp"

namespace ddtool {

std::unique_ptr<RobotLink> join_robot(const std::vector<std::string>& /*arguments*/) {
    become_other_program("ddtool-ros", "a DDS library (Fast DDS)");
}

}  // namespace ddtool

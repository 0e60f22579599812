#include "logs/messages/ros2_schema.hpp"

#include <gmock/gmock.h>

#include <sstream>

#include "logs/messages/ros_messages.hpp"

namespace ddtool {
namespace {

class Schema : public testing::TestWithParam<const char*> {};

TEST_P(Schema, DefinesEveryTypeThatItUses) {
    std::istringstream lines(ros2_schema(GetParam()));
    std::vector<std::string> defined;
    std::vector<std::string> used;
    for (std::string type, rest; lines >> type && std::getline(lines, rest);) {
        if (type == "MSG:") {
            defined.push_back(rest.substr(1));
        } else if (type.find('/') != std::string::npos) {
            used.push_back(type.substr(0, type.find('[')));
        }
    }
    EXPECT_THAT(defined, testing::Each(testing::AnyOfArray(used)));
    EXPECT_THAT(used, testing::Each(testing::AnyOfArray(defined)));
    EXPECT_FALSE(used.empty());
}

INSTANTIATE_TEST_SUITE_P(Types, Schema,
                         testing::Values(RosTFMessage::type_name, RosLaserScan::type_name, RosOdometry::type_name,
                                         RosPoseStamped::type_name, RosPoseArray::type_name, RosPath::type_name,
                                         RosOccupancyGrid::type_name, RosFloat64MultiArray::type_name));

}  // namespace
}  // namespace ddtool

#include "ros/type_hash.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "logs/messages/ros2_schema.hpp"
#include "logs/messages/ros_messages.hpp"
#include "system/checksums.hpp"

namespace ddtool {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// The type ids of type_description_interfaces/msg/FieldType (REP 2016); a message has 1.
int type_id(const std::string& name) {
    static const std::map<std::string, int> ids{
        {"int8", 2},   {"uint8", 3},    {"int16", 4},    {"uint16", 5}, {"int32", 6}, {"uint32", 7}, {"int64", 8},
        {"uint64", 9}, {"float32", 10}, {"float64", 11}, {"bool", 15},  {"byte", 16}, {"string", 17}};
    const auto found = ids.find(name);
    return found == ids.end() ? 1 : found->second;
}

std::string with_msg(std::string type) { return type.insert(type.find('/'), "/msg"); }

/// The description of one type from its definition, and the types that it uses.
OrderedJson described(const std::string& type, const std::string& definition, std::set<std::string>& used) {
    OrderedJson fields = OrderedJson::array();
    std::istringstream lines(definition);
    for (std::string line; std::getline(lines, line);) {
        static const std::regex form(R"(([\w/]+)(<=(\d+))?(\[(\d*)\])? (\w+).*)");
        std::smatch parts;
        if (!std::regex_match(line, parts, form)) {
            ADD_FAILURE() << line;
            continue;
        }
        const std::string base = parts[1];
        int id = type_id(base);
        const bool is_message = id == 1;
        if (is_message) {
            used.insert(base);
        }
        constexpr int bounded_string = 21;
        id = parts[3].matched ? bounded_string : id;
        id += !parts[4].matched ? 0 : parts[5].length() > 0 ? 48 : 144;
        fields.push_back({{"name", parts[6].str()},
                          {"type",
                           {{"type_id", id},
                            {"capacity", parts[5].length() > 0 ? std::stoi(parts[5]) : 0},
                            {"string_capacity", parts[3].matched ? std::stoi(parts[3]) : 0},
                            {"nested_type_name", is_message ? with_msg(base) : ""}}}});
    }
    return {{"type_name", with_msg(type)}, {"fields", fields}};
}

/// JSON on one line with a space after each comma and colon outside of texts, as the hash is defined over it.
std::string spaced(const std::string& json) {
    std::string text;
    bool in_text = false;
    for (const char c : json) {
        in_text = c == '"' ? !in_text : in_text;
        text += c;
        text += !in_text && (c == ',' || c == ':') ? " " : "";
    }
    return text;
}

/// Computes the hash from the definitions of the type and of those that it uses.
std::string computed_hash(const std::string& type_name) {
    std::map<std::string, std::string> definitions;
    std::string type = type_name;
    type.erase(type.find("/msg"), 4);
    std::string now = type;
    std::istringstream lines(ros2_schema(type_name));
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("MSG: ")) {
            now = line.substr(5);
        } else if (!line.starts_with("=")) {
            definitions[now] += line + "\n";
        }
    }
    std::set<std::string> used;
    OrderedJson description;
    description["type_description"] = described(type, definitions.at(type), used);
    description["referenced_type_descriptions"] = OrderedJson::array();
    std::map<std::string, OrderedJson> referenced;
    for (const auto& [name, text] : definitions) {
        if (name != type) {
            referenced[with_msg(name)] = described(name, text, used);
        }
    }
    for (const auto& [name, each] : referenced) {
        description["referenced_type_descriptions"].push_back(each);
    }
    return "RIHS01_" + sha256_of(spaced(description.dump()));
}

class TypeHash : public testing::TestWithParam<const char*> {};

TEST_P(TypeHash, IsThatOfTheDefinition) { EXPECT_EQ(type_hash(GetParam()), computed_hash(GetParam())); }

INSTANTIATE_TEST_SUITE_P(Types, TypeHash,
                         testing::Values(RosDegeneracy::type_name, RosDiagnosticArray::type_name,
                                         RosPoseArray::type_name, RosPoseWithCovarianceStamped::type_name,
                                         RosOccupancyGrid::type_name, RosOdometry::type_name, RosPath::type_name,
                                         RosParticipantEntities<16>::type_name, RosClock::type_name, RosImu::type_name,
                                         RosLaserScan::type_name, RosPointCloud2::type_name, RosTFMessage::type_name));

/// ROS 2 itself prints these for its installed types.
TEST(TypeHashOfRos2, IsTheSameForItsOwnTypes) {
    EXPECT_THAT(std::string(type_hash("sensor_msgs/msg/LaserScan")), testing::StartsWith("RIHS01_64c19139"));
    EXPECT_THAT(computed_hash("std_msgs/msg/Header"), testing::StartsWith("RIHS01_f49fb3ae"));
    EXPECT_EQ(type_hash("std_msgs/msg/Unknown"), "");
}

}  // namespace
}  // namespace ddtool

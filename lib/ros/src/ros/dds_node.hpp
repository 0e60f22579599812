#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>

#include "ros/ros_environment.hpp"

namespace ddtool {

/// What ROS 2 calls quality of service. A reader that wants more than a writer offers gets nothing from it.
struct TopicQos {
    bool reliable = true;           ///< what is lost on the way is sent again
    bool is_kept_for_late = false;  ///< the latest message is kept and sent to who joins late (transient local)
    int depth = 10;                 ///< messages that are kept until they are read
};

/// The DDS type name of a ROS 2 message type: "sensor_msgs::msg::dds_::LaserScan_" of "sensor_msgs/msg/LaserScan".
std::string dds_type_name(const std::string& type_name);

/// A node in the graph of ROS 2 programs, joined through DDS (Fast DDS, over UDP): it reads and writes topics whose
/// messages are ready CDR bytes (XCDR version 1), and tells its name, so that `ros2 node list` shows it. No IDL and no
/// type information are needed, because ROS 2 matches topics by the names of their types.
///
/// Topics are subscribed to by one thread; write() may be called by several.
class DdsNode {
public:
    /// Called with each message, on a thread of DDS; calls for one topic do not overlap. The bytes are valid during the
    /// call.
    using Receive = std::function<void(std::span<const std::byte>)>;

    /// Joins the graph. Throws Error if that is not possible.
    DdsNode(const RosEnvironment& environment, const std::string& name, const std::string& name_space);
    ~DdsNode();
    DdsNode(const DdsNode&) = delete;
    DdsNode& operator=(const DdsNode&) = delete;

    /// \param topic absolute name, as ROS 2 has it
    /// What this node writes itself is not received. A writer whose quality of service does not suffice is reported as
    /// a warning.
    void subscribe(const std::string& topic, const std::string& type_name, const TopicQos& qos, Receive receive);
    /// The first message of a topic decides on its type and quality of service.
    void write(const std::string& topic, const std::string& type_name, const TopicQos& qos,
               std::span<const std::byte> message);
    /// How many writers of a topic that is subscribed to are there now. Any thread may ask.
    [[nodiscard]] std::size_t writers_of(const std::string& topic) const;

private:
    class Graph;
    std::unique_ptr<Graph> graph_;
};

}  // namespace ddtool

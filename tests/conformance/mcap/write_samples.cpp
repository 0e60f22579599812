// write_mcap_samples DIR: writes the same ROS 2 messages into DIR with every compression, in many chunks and in one
// chunk, and expected.json, which states what a reader must find in each file. read_back.mjs reads them.

#include <filesystem>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "ddtool/base/error.hpp"
#include "ddtool/system/settings.hpp"
#include "logs/containers/mcap_writer.hpp"
#include "logs/messages/ros2_schema.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_messages.hpp"
#include "system/atomic_file.hpp"

namespace ddtool {
namespace {

struct Sample {
    std::string topic;
    std::string type;
    std::int64_t log_time_ns = 0;
    std::vector<std::byte> data;
    Json message;  ///< with the names of the fields in the message's definition
};

template <typename Message>
Sample sample(std::string topic, std::int64_t log_time_ns, const Message& message, Json json) {
    return {std::move(topic), Message::type_name, log_time_ns, encode_cdr(message), std::move(json)};
}

constexpr std::int64_t stamp_ns = 1'700'000'000'000'000'250;

RosHeader header() { return {{stamp_ns}, "laser"}; }
Json header_json() { return {{"stamp", {{"sec", 1'700'000'000}, {"nanosec", 250}}}, {"frame_id", "laser"}}; }

RosPose pose(double x) { return {{x, -x, 0.5}, {0.0, 0.0, 0.6, 0.8}}; }
Json vector_json(double x) { return {{"x", x}, {"y", -x}, {"z", 0.5}}; }
Json pose_json(double x) {
    return {{"position", vector_json(x)}, {"orientation", {{"x", 0}, {"y", 0}, {"z", 0.6}, {"w", 0.8}}}};
}

Sample scan(std::int64_t log_time_ns, std::size_t beams) {
    RosLaserScan scan{header(), -0.5F, 0.5F, 0.25F, 0.125F, 0.0625F, 0.25F, 30.0F, {}, {}};
    for (std::size_t beam = 0; beam < beams; ++beam) {
        scan.ranges.push_back(0.5F * static_cast<float>(beam));
    }
    return sample("/scan", log_time_ns, scan,
                  {{"header", header_json()},
                   {"angle_min", -0.5},
                   {"angle_max", 0.5},
                   {"angle_increment", 0.25},
                   {"time_increment", 0.125},
                   {"scan_time", 0.0625},
                   {"range_min", 0.25},
                   {"range_max", 30},
                   {"ranges", scan.ranges},
                   {"intensities", Json::array()}});
}

Sample transforms(std::int64_t log_time_ns) {
    const RosTFMessage message{{{header(), "base", pose(1.5)}, {header(), "", pose(-2.0)}}};
    const auto transform = [](double x) {
        return Json{{"translation", vector_json(x)}, {"rotation", pose_json(x).at("orientation")}};
    };
    return sample("/tf", log_time_ns, message,
                  {{"transforms",
                    {{{"header", header_json()}, {"child_frame_id", "base"}, {"transform", transform(1.5)}},
                     {{"header", header_json()}, {"child_frame_id", ""}, {"transform", transform(-2.0)}}}}});
}

Sample odometry(std::int64_t log_time_ns) {
    RosOdometry message{header(), "base", pose(3.25), {}, {1.0, -1.0, 0.5}, {2.0, -2.0, 0.5}, {}};
    message.pose_covariance[7] = 0.25;
    message.velocity_covariance[35] = 0.75;
    return sample("/odom", log_time_ns, message,
                  {{"header", header_json()},
                   {"child_frame_id", "base"},
                   {"pose", {{"pose", pose_json(3.25)}, {"covariance", message.pose_covariance}}},
                   {"twist",
                    {{"twist", {{"linear", vector_json(1.0)}, {"angular", vector_json(2.0)}}},
                     {"covariance", message.velocity_covariance}}}});
}

Json pose_stamped_json(double x) { return {{"header", header_json()}, {"pose", pose_json(x)}}; }

Sample path(std::int64_t log_time_ns) {
    const RosPath message{header(), {{header(), pose(1.0)}, {header(), pose(2.0)}}};
    return sample("/path", log_time_ns, message,
                  {{"header", header_json()}, {"poses", {pose_stamped_json(1.0), pose_stamped_json(2.0)}}});
}

Sample particles(std::int64_t log_time_ns) {
    const RosPoseArray message{header(), {pose(0.25), pose(0.75)}};
    return sample("/particles", log_time_ns, message,
                  {{"header", header_json()}, {"poses", {pose_json(0.25), pose_json(0.75)}}});
}

Sample truth(std::int64_t log_time_ns) {
    return sample("/truth", log_time_ns, RosPoseStamped{header(), pose(9.0)}, pose_stamped_json(9.0));
}

Sample map(std::int64_t log_time_ns) {
    const RosOccupancyGrid message{header(), {stamp_ns}, 0.0625F, 3, 2, pose(-4.0), {0, 100, -1, 50, 99, 1}};
    return sample("/map", log_time_ns, message,
                  {{"header", header_json()},
                   {"info",
                    {{"map_load_time", header_json().at("stamp")},
                     {"resolution", 0.0625},
                     {"width", 3},
                     {"height", 2},
                     {"origin", pose_json(-4.0)}}},
                   {"data", message.data}});
}

/// The messages are not in the order of their times, so that the order in the file differs from that in the index.
std::vector<Sample> samples() {
    return {transforms(20), scan(10, 5), odometry(40), scan(30, 0),  path(70),
            particles(50),  truth(60),   map(90),      scan(80, 720)};
}

void write(const std::filesystem::path& file, const McapWriterOptions& options) {
    McapWriter writer(file, options);
    std::map<std::string, std::uint16_t> channels;
    for (const Sample& one : samples()) {
        if (!channels.contains(one.topic)) {
            channels[one.topic] = writer.add_channel(one.topic, "cdr", one.type, "ros2msg", ros2_schema(one.type));
        }
        writer.write(channels[one.topic], one.log_time_ns, one.data);
    }
    writer.close();
}

Json expected() {
    Json json = Json::array();
    std::map<std::string, std::uint32_t> counts;
    for (const Sample& one : samples()) {
        json.push_back({{"topic", one.topic},
                        {"type", one.type},
                        {"sequence", counts[one.topic]++},
                        {"logTime", one.log_time_ns},
                        {"message", one.message}});
    }
    return json;
}

void write_all(const std::filesystem::path& folder) {
    const std::map<std::string, Compression> compressions = {
        {"none", Compression::none}, {"lz4", Compression::lz4}, {"zstd", Compression::zstd}};
    for (const auto& [name, compression] : compressions) {
        write(folder / ("chunks_" + name + ".mcap"), {"ros2", compression, 1000});
        write(folder / ("one_chunk_" + name + ".mcap"), {"ros2", compression, std::size_t{1} << 20});
    }
    write_file(folder / "expected.json", expected().dump(1));
}

}  // namespace
}  // namespace ddtool

int main(int argc, char** argv) {
    if (argc != 2) {
        std::cerr << "usage: write_mcap_samples DIR\n";
        return 2;
    }
    try {
        ddtool::write_all(argv[1]);
    } catch (const ddtool::Error& error) {
        std::cerr << error.what() << '\n';
        return 1;
    }
    return 0;
}

#include <fmt/format.h>

#include "bag_file.hpp"
#include "base/atomic_file.hpp"
#include "db3_file.hpp"
#include "known_dataset.hpp"
#include "message_kinds.hpp"
#include "recording.hpp"
#include "rosbag2_folder_files.hpp"
#include "swarm_dataset.hpp"

namespace ddtool::fuzz {
namespace {

namespace fs = std::filesystem;

std::string text_of(const std::vector<std::byte>& bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void write_seed(const fs::path& folder, const std::string& name, const std::string& content) {
    fs::create_directories(folder);
    write_file(folder / name, content);
}

void write_logs(const fs::path& folder) {
    const test::Recording recording = test::example_recording();
    fs::create_directories(folder);
    for (const auto& [name, compression] : {std::pair{"none", Compression::none}, {"lz4", Compression::lz4}}) {
        write_seed(folder, std::string(name) + ".bag", test::BagFile(recording, {.compression = compression}).bytes());
        test::write_mcap(folder / (std::string(name) + ".mcap"), recording, {.compression = compression});
    }
    write_seed(folder, "bz2.bag", test::BagFile(recording, {.compression = Compression::bzip2}).bytes());
    write_seed(folder, "unclosed.bag", test::BagFile(recording, {.closed = false}).bytes());
    test::write_mcap(folder / "zstd.mcap", recording, {.compression = Compression::zstd});
    const test::Recording short_recording(recording.begin(), recording.begin() + 8);
    fs::remove(folder / "small.db3");
    test::write_db3(folder / "small.db3", short_recording);
    fs::remove(folder / "packed.db3");
    test::write_db3(folder / "packed.db3", short_recording, Compression::zstd);
    write_seed(folder, "small.clf",
               "PARAM robot_front_laser_max 80\nFLASER 3 1 1 1 0 0 0 0 0 0 1 host 1\nODOM 0 0 0 0 0 0 1 host 1\n"
               "ROBOTLASER1 0 -1.5 3.1 1 80 0.01 0 3 1 2 3 0 0 0 0 0 0 0 0 0 0 0 0 1 host 1\n");
}

std::string as_json(const std::string& schema) {
    const std::string pose = R"({"position":{"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}})";
    const std::string head = R"({"timestamp":{"sec":1,"nsec":2},"frame_id":"a",)";
    const std::string transform =
        head + R"("parent_frame_id":"a","child_frame_id":"b","translation":{"x":1},"rotation":{"w":1}})";
    if (schema == "foxglove.LaserScan") {
        return head + R"("pose":)" + pose + R"(,"start_angle":-1,"end_angle":1,"ranges":[1,null,3]})";
    }
    if (schema == "foxglove.PoseInFrame") {
        return head + R"("pose":)" + pose + "}";
    }
    return schema == "foxglove.FrameTransform" ? transform : R"({"transforms":[)" + transform + "]}";
}

/// ROS messages of the recording with the type's name, if there is one.
std::string as_ros(const MessageType& type) {
    for (const test::RecordedMessage& message : test::example_recording()) {
        if (message.ros2_type == type.schema) {
            return text_of(message.cdr);
        }
        if (message.ros1_type() == type.schema) {
            return text_of(message.ros1);
        }
    }
    return type.encoding == std::string("cdr") ? text_of(ros::encode_cdr(ros::Float64MultiArray{})) : "";
}

void write_messages(const fs::path& folder) {
    for (std::size_t row = 0; row < message_types.size(); ++row) {
        const MessageType& type = message_types[row];
        const std::string bytes = type.encoding == std::string("json") ? as_json(type.schema) : as_ros(type);
        write_seed(folder, fmt::format("{}", row), std::string(1, static_cast<char>(row)) + bytes);
    }
}

void write_datasets(const fs::path& folder) {
    const test::TemporaryFolder temporary;
    fs::create_directory(temporary / "data");
    test::write_swarm_dataset(temporary / "data", 10);
    for (const auto& entry : fs::directory_iterator(temporary / "data")) {
        const std::string name = entry.path().filename().string();
        const char choice = name == dataset::manifest_name ? '\0' : name.find("samples") != std::string::npos ? 1 : 2;
        write_seed(folder, name, choice + read_file(entry.path()));
    }
}

void write_rest(const fs::path& root) {
    fs::create_directories(root / "metadata");
    test::write_metadata(root / "metadata", {"part_0.db3", "part_1.db3"});
    write_seed(root / "poses", "two.tum", "1.0 0 0 0 0 0 0 1\n2.0 1 0 0 0 0 0.6 0.8\n");
    write_seed(root / "poses", "one.relations", "1.0 2.0 1 0 0 0 0 0.1\n");
    write_seed(root / "configuration", "filter.json",
               R"({"particles": 30, "method": "paper", "matcher": {"reach_m": 0.2}})");
    write_seed(root / "configuration", "world.json",
               R"({"name": "w", "description": "d", "start": [0, 0, 90], "way_points": [[1, 0]], "laps": 2,)"
               R"("walls": [[[-1, -1], [2, -1]]], "boxes": [{"centre": [5, 2], "size": [2, 1], "heading_deg": 30}],)"
               R"("circles": [{"centre": [3, 4], "radius_m": 0.3}],)"
               R"("arcs": [{"centre": [0, 0], "radius_m": 8, "from_deg": 0, "to_deg": 90}]})");
    write_seed(root / "configuration", "train.json",
               R"({"optimizer": {"name": "adamw", "learning_rate": 0.01}, "image": {"size_px": 64}})");
    write_seed(root / "request", "subscribe", R"({"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 2}]})");
    write_seed(root / "request", "unsubscribe", R"({"op": "unsubscribe", "subscriptionIds": [1]})");
}

}  // namespace
}  // namespace ddtool::fuzz

/// fuzz_seeds DIR: sound inputs to begin from, in DIR/READER.
int main(int argc, char** argv) {
    if (argc != 2) {
        return 2;
    }
    const std::filesystem::path root = argv[1];
    ddtool::fuzz::write_logs(root / "log");
    ddtool::fuzz::write_messages(root / "message");
    ddtool::fuzz::write_datasets(root / "dataset");
    ddtool::fuzz::write_rest(root);
    return 0;
}

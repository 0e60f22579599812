#include <fmt/format.h>

#include <cstring>

#include "bag_file.hpp"
#include "compressed_text.hpp"
#include "db3_file.hpp"
#include "dd_weights.hpp"
#include "ddtool/filter/learnt_odometry.hpp"
#include "foxglove.pb.h"
#include "graph/node_recorder.hpp"
#include "known_dataset.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "map_messages.hpp"
#include "maps/map_file.hpp"
#include "message_kinds.hpp"
#include "point_clouds.hpp"
#include "recording.hpp"
#include "rosbag2_folder_files.hpp"
#include "run/snapshot_file.hpp"
#include "small_run.hpp"
#include "swarm_dataset.hpp"
#include "system/atomic_file.hpp"
#include "tar_file.hpp"
#include "train/training_state.hpp"

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

/// The example recording with messages of the types that it lacks: a second lidar of several echoes, a lidar of many
/// rings, a gyro, velocities and poses.
test::Recording recording_of_everything() {
    test::Recording recording = test::example_recording();
    for (std::int64_t stamp_ns = 50'000'000; stamp_ns < 1'000'000'000; stamp_ns += 100'000'000) {
        const RosHeader header{{stamp_ns}, "laser"};
        RosMultiEchoLaserScan echoes;
        echoes.header = {{stamp_ns}, "laser_2"};
        echoes.angle_increment = 0.5F;
        echoes.range_max = 10.0F;
        echoes.ranges = {{{1.0F, 2.0F}}, {{3.0F}}, {}};
        test::record(recording, "/echoes", stamp_ns, echoes);
        test::record(
            recording, "/points", stamp_ns,
            test::cloud_message(1e-9 * static_cast<double>(stamp_ns), "laser", test::round_room(3.0, 0.3, 2, 8)));
        test::record(recording, "/imu", stamp_ns, RosImu{.header = header, .angular_velocity = {0.0, 0.0, 0.1}});
        const RosTwistStamped twist{header, {0.5, 0.0, 0.0}, {0.0, 0.0, 0.1}};
        test::record(recording, "/twist", stamp_ns, twist);
        test::record(recording, "/twist_covariance", stamp_ns, RosTwistWithCovarianceStamped{.twist = twist});
        test::record(recording, "/pose", stamp_ns, pose_message(stamp_ns, "odom", {1.0, 2.0, 0.5}));
        test::record(recording, "/pose_covariance", stamp_ns, RosPoseWithCovarianceStamped{.header = header});
    }
    test::record(recording, "/fisher_information", 1,
                 RosFloat64MultiArray{{{"row", 3, 9}, {"column", 3, 3}}, 0, std::vector<double>(9, 1.0)});
    return recording;
}

/// The messages of these topics alone. Without the kinds that are used before others, the others are read.
test::Recording recording_of(const std::vector<std::string>& topics) {
    test::Recording recording = recording_of_everything();
    std::erase_if(recording, [&](const test::RecordedMessage& message) {
        return std::ranges::find(topics, message.topic) == topics.end();
    });
    return recording;
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
    const McapWriterOptions plain{.compression = Compression::none};
    test::write_mcap(folder / "everything.mcap", recording_of_everything(), plain);
    test::write_mcap(folder / "cloud-and-twist.mcap", recording_of({"/tf", "/points", "/twist_covariance"}), plain);
    test::write_mcap(folder / "echoes-and-pose.mcap", recording_of({"/tf", "/echoes", "/pose_covariance"}), plain);
    test::write_mcap(folder / "gyro-alone.mcap", recording_of({"/tf", "/scan", "/imu"}), plain);
    const test::Recording short_recording(recording.begin(), recording.begin() + 8);
    fs::remove(folder / "small.db3");
    test::write_db3(folder / "small.db3", short_recording);
    fs::remove(folder / "packed.db3");
    test::write_db3(folder / "packed.db3", short_recording, Compression::zstd);
    const std::string carmen =
        "PARAM robot_front_laser_max 80\nFLASER 3 1 1 1 0 0 0 0 0 0 1 host 1\nODOM 0 0 0 0 0 0 1 host 1\n"
        "ROBOTLASER1 0 -1.5 3.1 1 80 0.01 0 3 1 2 3 0 0 0 0 0 0 0 0 0 0 0 0 1 host 1\n";
    write_seed(folder, "small.clf", carmen);
    write_seed(folder, "small.clf.gz", test::gzip(carmen));
    write_seed(folder, "small.clf.bz2", test::bzip2(carmen));
    write_seed(folder, "small.tar.gz", test::gzip(test::tar_archive({{"a/notes", "n"}, {"a/small.clf", carmen}})));
    write_seed(folder, "small.tar", test::tar_archive({{"a.db3", read_file(folder / "small.db3")}}));
    write_seed(folder, "small.db3.gz", test::gzip(read_file(folder / "small.db3")));
    SnapshotWriter snapshots(folder / "snapshots.mcap");
    snapshots.write({.stamp_ns = 1, .update = 2, .odometry_motion = {}, .particles = test::clear_swarm(true, 1)}, {});
    snapshots.close();
}

std::string as_json(const std::string& schema) {
    const std::string pose = R"({"position":{"x":1,"y":2,"z":0},"orientation":{"x":0,"y":0,"z":0,"w":1}})";
    const std::string head = R"({"timestamp":{"sec":1,"nsec":2},"frame_id":"a",)";
    const std::string transform = head +
                                  R"("parent_frame_id":"a","child_frame_id":"b","translation":{"x":1,"y":0,"z":0},)" +
                                  R"("rotation":{"x":0,"y":0,"z":0,"w":1}})";
    if (schema == "foxglove.LaserScan") {
        return head + R"("pose":)" + pose + R"(,"start_angle":-1,"end_angle":1,"ranges":[1,null,3]})";
    }
    if (schema == "foxglove.PoseInFrame") {
        return head + R"("pose":)" + pose + "}";
    }
    if (schema == "foxglove.PointCloud") {
        return head + R"("pose":)" + pose +
               R"(,"point_stride":12,"fields":[{"name":"x","offset":0,"type":7},{"name":"y","offset":4,"type":7},)" +
               R"({"name":"z","offset":8,"type":7}],"data":"AACAPwAAAEAAAAAA"})";
    }
    return schema == "foxglove.FrameTransform" ? transform : R"({"transforms":[)" + transform + "]}";
}

void fill(FoxgloveFrameTransform& transform) {
    transform.mutable_timestamp()->set_seconds(1);
    transform.set_parent_frame_id("a");
    transform.set_child_frame_id("b");
    transform.mutable_translation()->set_x(1.0);
    transform.mutable_rotation()->set_w(1.0);
}

std::string as_protobuf(const std::string& schema) {
    if (schema == "foxglove.LaserScan") {
        FoxgloveLaserScan scan;
        scan.mutable_timestamp()->set_nanos(2);
        scan.set_frame_id("a");
        scan.mutable_pose()->mutable_orientation()->set_w(1.0);
        scan.set_end_angle(1.0);
        scan.add_ranges(1.0);
        scan.add_ranges(2.0);
        return scan.SerializeAsString();
    }
    if (schema == "foxglove.PoseInFrame") {
        FoxglovePoseInFrame pose;
        pose.set_frame_id("a");
        pose.mutable_pose()->mutable_position()->set_x(1.0);
        return pose.SerializeAsString();
    }
    if (schema == "foxglove.PointCloud") {
        FoxglovePointCloud cloud;
        cloud.set_frame_id("a");
        cloud.mutable_pose()->mutable_orientation()->set_w(1.0);
        cloud.set_point_stride(12);
        for (const char* axis : {"x", "y", "z"}) {
            FoxglovePackedElementField& field = *cloud.add_fields();
            field.set_name(axis);
            field.set_offset(4U * static_cast<std::uint32_t>(*axis - 'x'));
            field.set_type(7);
        }
        cloud.set_data(std::string(24, '\x3F'));
        return cloud.SerializeAsString();
    }
    FoxgloveFrameTransforms transforms;
    fill(*transforms.add_transforms());
    return schema == "foxglove.FrameTransform" ? transforms.transforms(0).SerializeAsString()
                                               : transforms.SerializeAsString();
}

/// The first message of that type in the recording.
std::string as_ros(const MessageType& type, const test::Recording& recording) {
    const bool ros1 = type.encoding == std::string("ros1");
    const std::string schema = type.schema == std::string("tf/tfMessage") ? "tf2_msgs/TFMessage" : type.schema;
    const auto found = std::ranges::find_if(recording, [&](const test::RecordedMessage& message) {
        return (ros1 ? message.ros1_type() : message.ros2_type) == schema;
    });
    if (found == recording.end()) {
        throw std::logic_error("no seed of type " + schema);
    }
    return text_of(ros1 ? found->ros1 : found->cdr);
}

void write_messages(const fs::path& folder) {
    const test::Recording recording = recording_of_everything();
    for (std::size_t row = 0; row < message_types.size(); ++row) {
        const MessageType& type = message_types.at(row);
        const std::string encoding = type.encoding;
        const std::string bytes = encoding == "json"       ? as_json(type.schema)
                                  : encoding == "protobuf" ? as_protobuf(type.schema)
                                                           : as_ros(type, recording);
        write_seed(folder, fmt::format("{}", row), std::string(1, static_cast<char>(row)) + bytes);
    }
}

/// Writes the header only, which lists the lengths and names of all weights. The weights themselves are left out,
/// because changing them would find nothing.
void write_networks(const fs::path& folder) {
    const test::TemporaryFolder temporary;
    network::write_safetensors(temporary / "model", test::drawn_dd_model("ddmodel-lite", 16));
    const std::string whole = read_file(temporary / "model");
    std::uint64_t header_bytes = 0;
    std::memcpy(&header_bytes, whole.data(), sizeof header_bytes);
    write_seed(folder, "header", whole.substr(0, sizeof header_bytes + header_bytes));
}

void write_checkpoints(const fs::path& folder) {
    train::TrainingState state;
    state.history.resize(2);
    write_seed(folder, "state", Json(state).dump());
    write_seed(folder, "description", test::drawn_dd_model("ddmodel-lite", 64).about);
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

/// The messages of an MCAP file in the form of map_messages.hpp.
std::string as_map_messages(const fs::path& file) {
    McapReader reader(file, {});
    std::string all;
    while (const std::optional<McapMessage> message = reader.next()) {
        const auto* const found = std::ranges::find_if(
            map_messages, [&](const MapMessage& known) { return known.topic == message->channel->topic; });
        all += static_cast<char>(found - map_messages.begin());
        all += static_cast<char>(message->data.size() & 0xffU);
        all += static_cast<char>(message->data.size() >> 8U);
        all.append(reinterpret_cast<const char*>(message->data.data()), message->data.size());
    }
    return all;
}

/// A map of two scans, and one of two cells, each as a file and as messages.
void write_maps(const fs::path& folder) {
    const test::TemporaryFolder temporary;
    test::SmallRun small;
    graph::NodeRecorder recorder(test::SmallRun::settings());
    maps::SavedMap map{OccupancySettings{}};
    const FilterRun run = small.run([&](const SensorFrame& frame, const std::optional<Update>& update) {
        if (std::optional<graph::Node> node = recorder.add(frame, update)) {
            map.nodes.push_back({.drive = 0, .scan = std::move(*node), .pose = {}});
        }
        return map.nodes.size() < 2;
    });
    map.drives = {{.log = "log", .odometry = LearntOdometry().state()}};
    map.edges = {{maps::MapEdge::Kind::match, {.from = 0, .to = 1, .measured = {0.3, 0.0, 0.0}}}};
    map.grid = run.map;
    maps::write_map(temporary / "whole", "fuzz", map);
    write_seed(folder, "whole", read_file(temporary / "whole"));
    write_seed(folder, "whole-messages", as_map_messages(temporary / "whole"));
    map.nodes.clear();
    map.edges.clear();
    map.drives.clear();
    map.grid = OccupancyGrid({});
    map.grid.reserve({0, 0, 2, 1});
    map.grid.set({0, 0}, 5, {1, -1});
    map.grid.set({1, 0}, -5, {});
    maps::write_map(temporary / "small", "fuzz", map);
    write_seed(folder, "small", read_file(temporary / "small"));
    write_seed(folder, "small-messages", as_map_messages(temporary / "small"));
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

/// fuzz_seeds DIR: writes sound inputs, from which fuzzing begins, into DIR/READER.
int main(int argc, char** argv) {
    if (argc != 2) {
        return 2;
    }
    const std::filesystem::path root = argv[1];
    ddtool::fuzz::write_logs(root / "log");
    ddtool::fuzz::write_messages(root / "message");
    ddtool::fuzz::write_datasets(root / "dataset");
    ddtool::fuzz::write_networks(root / "network");
    ddtool::fuzz::write_checkpoints(root / "checkpoint");
    ddtool::fuzz::write_maps(root / "map");
    ddtool::fuzz::write_rest(root);
    return 0;
}

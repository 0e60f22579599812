#include "readers.hpp"

#include <cmath>
#include <stdexcept>

#include "dataset/build_settings.hpp"
#include "ddtool/base/error.hpp"
#include "ddtool/logs/log_stream.hpp"
#include "ddtool/network/load_model.hpp"
#include "ddtool/network/model_description.hpp"
#include "ddtool/system/settings.hpp"
#include "input_file.hpp"
#include "logs/containers/rosbag2_folder.hpp"
#include "logs/stream/log_inventory.hpp"
#include "methods/settings_json.hpp"
#include "run/foxglove_protocol.hpp"
#include "run/snapshot_file.hpp"
#include "scores/relations.hpp"
#include "scores/tum_file.hpp"
#include "sim/simulation_json.hpp"
#include "sim/world_catalogue.hpp"
#include "study/ablation/plan.hpp"
#include "study/compare/experiment.hpp"
#include "train/train_settings.hpp"
#include "train/training_state.hpp"

namespace ddtool::fuzz {
namespace {

/// A small input that gives more scans than this has been read wrongly.
constexpr std::size_t most_scans = 100'000;

void ignore(const LogProblem& /*problem*/) {}

void expect_sound(const SensorFrame& frame) {
    for (const Pose2& pose :
         {frame.odom_from_robot, frame.robot_from_laser, frame.world_from_robot.value_or(Pose2{})}) {
        if (!std::isfinite(pose.x_m) || !std::isfinite(pose.y_m) || !std::isfinite(pose.theta_rad)) {
            throw std::logic_error("a pose that is no number came through");
        }
    }
}

/// Reads a log. Bags, MCAP, .db3 and CARMEN files are told apart by their content.
void read_log(std::span<const char> content) {
    const std::filesystem::path path = input_file(content, "log");
    const std::unique_ptr<LogStream> log = open_log(path, {}, ignore);
    std::size_t scans = 0;
    while (const std::optional<SensorFrame> frame = log->next()) {
        expect_sound(*frame);
        if (++scans > most_scans) {
            throw std::logic_error("more scans than the bytes can hold");
        }
    }
}

void read_inventory(std::span<const char> content) {
    (void)take_inventory(input_file(content, "log"), ignore, [](double /*share*/) {});
}

void read_snapshots(std::span<const char> content) {
    SnapshotReader snapshots(input_file(content, "log"), ignore);
    while (snapshots.next()) {
    }
}

void read_metadata(std::span<const char> content) {
    (void)rosbag2_files(input_file(content, "metadata.yaml").parent_path(), ignore);
}

void read_network(std::span<const char> content) {
    (void)load_model(std::string_view(content.data(), content.size()), "model.safetensors");
}

/// Reads the input as the header of a network file. Zeros are appended in place of the weights, so that the reader gets
/// beyond the header and constructs the network.
void read_network_header(std::span<const char> content) {
    constexpr std::size_t most_weights_bytes = 512 << 10;
    std::string bytes(content.begin(), content.end());
    read_network({bytes.append(most_weights_bytes, '\0').data(), bytes.size()});
}

void read_description(std::span<const char> content) {
    (void)parse_model_description(std::string(content.begin(), content.end()), "model");
}

/// Does the same as train/torch/checkpoint.cpp, which needs LibTorch.
void read_training_state(std::span<const char> content) {
    try {
        (void)parse_json({content.data(), content.size()}, "state").get<train::TrainingState>();
    } catch (const Json::exception& error) {
        throw Error(error.what());
    }
}

void read_filter_settings(std::span<const char> content) {
    Json filter = filter_settings_json({});
    merge_settings_file(filter, input_file(content, "settings.json"));
    (void)filter_settings_from_json(filter);
}

void read_experiment(std::span<const char> content) {
    Json experiment = compare::default_experiment_json();
    merge_settings_file(experiment, input_file(content, "settings.json"));
    (void)compare::experiment_from_json(experiment);
}

void read_build_settings(std::span<const char> content) {
    Json build = dataset::default_build_json();
    merge_settings_file(build, input_file(content, "settings.json"));
    (void)dataset::assembly_from_json(build);
}

void read_train_settings(std::span<const char> content) {
    const train::TrainSettings defaults;
    Json train = defaults;
    merge_settings_file(train, input_file(content, "settings.json"));
    (void)train::train_settings_from_json(train);
}

void read_simulation(std::span<const char> content) {
    Json simulation = sim::default_simulation_json();
    merge_settings_file(simulation, input_file(content, "settings.json"));
    (void)sim::simulation_from_json(simulation);
}

void read_plan(std::span<const char> content) {
    Json plan = ablation::default_plan_json();
    merge_settings_file(plan, input_file(content, "settings.json"));
    (void)ablation::plan_from_json(plan);
}

void read_world(std::span<const char> content) { (void)sim::load_world(input_file(content, "world.json").string()); }

void read_trajectory(std::span<const char> content) { (void)read_tum(input_file(content, "trajectory.tum")); }

void read_relation_file(std::span<const char> content) { (void)read_relations(input_file(content, "log.relations")); }

void read_request(std::span<const char> content) {
    (void)parse_foxglove_request(std::string(content.begin(), content.end()));
}

using Read = void (*)(std::span<const char>);

/// Catches ddtool::Error, which is the right answer to a damaged input.
void read_tolerantly(Read read, std::span<const char> content) {
    try {
        read(content);
    } catch (const Error&) {
    }
}

/// One reader made of several. An input that only one of them understands costs the others little time.
Reader reader(std::vector<Read> reads) {
    return [reads = std::move(reads)](std::span<const char> content) {
        for (const Read read : reads) {
            read_tolerantly(read, content);
        }
    };
}

}  // namespace

const std::map<std::string, Reader>& readers() {
    static const std::map<std::string, Reader> all{
        {"log", reader({read_log, read_inventory, read_snapshots})},
        {"message", reader({read_message})},
        {"metadata", reader({read_metadata})},
        {"dataset", reader({read_dataset})},
        {"network", reader({read_network, read_network_header})},
        {"checkpoint", reader({read_description, read_training_state})},
        {"configuration", reader({read_filter_settings, read_experiment, read_simulation, read_build_settings,
                                  read_train_settings, read_plan, read_world})},
        {"poses", reader({read_trajectory, read_relation_file})},
        {"map", reader({read_map_file, read_map_messages})},
        {"request", reader({read_request})}};
    return all;
}

}  // namespace ddtool::fuzz

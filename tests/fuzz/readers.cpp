#include "readers.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/error.hpp"
#include "base/settings.hpp"
#include "compare/experiment.hpp"
#include "eval/relations.hpp"
#include "geometry/tum_file.hpp"
#include "logs/log_inventory.hpp"
#include "logs/log_stream.hpp"
#include "native/load_model.hpp"
#include "slam/settings_json.hpp"
#include "temporary_folder.hpp"

namespace ddtool::fuzz {
namespace {

/// Beyond this many scans a small input has been read as something that it is not.
constexpr std::size_t most_scans = 100'000;

/// Not by write_file(): nothing here need outlive a crash, and a rename for each of a million inputs takes its time.
std::filesystem::path written(std::span<const char> content, const std::string& name) {
    static const test::TemporaryFolder folder;
    const std::filesystem::path path = folder / name;
    std::ofstream(path, std::ios::binary | std::ios::trunc)
        .write(content.data(), static_cast<std::streamsize>(content.size()));
    return path;
}

void ignore(const LogProblem& /*problem*/) {}

void expect_sound(const SensorFrame& frame) {
    if (!std::isfinite(frame.odom_from_robot.x_m) || !std::isfinite(frame.odom_from_robot.theta_rad)) {
        throw std::logic_error("an odometry that is no number came through");
    }
}

/// Bags, MCAP, .db3 and CARMEN are told apart by content.
void read_log(std::span<const char> content) {
    const std::filesystem::path path = written(content, "log");
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
    (void)take_inventory(written(content, "log"), ignore, [](double /*share*/) {});
}

void read_settings(std::span<const char> content) {
    Json filter = filter_settings_json({});
    merge_settings_file(filter, written(content, "settings.json"));
    (void)filter_settings_from_json(filter);
}

void read_experiment(std::span<const char> content) {
    Json experiment = compare::default_experiment_json();
    merge_settings_file(experiment, written(content, "experiment.json"));
    (void)compare::experiment_from_json(experiment);
}

void read_network(std::span<const char> content) {
    (void)native::load_model(std::string_view(content.data(), content.size()), "model.safetensors");
}

void read_trajectory(std::span<const char> content) { (void)read_tum(written(content, "trajectory.tum")); }

void read_relation_file(std::span<const char> content) { (void)read_relations(written(content, "log.relations")); }

/// Errors of ours are answers.
Reader tolerant(void (*read)(std::span<const char>)) {
    return [read](std::span<const char> content) {
        try {
            read(content);
        } catch (const Error&) {
        }
    };
}

}  // namespace

const std::map<std::string, Reader>& readers() {
    static const std::map<std::string, Reader> all{{"log", tolerant(read_log)},
                                                   {"inventory", tolerant(read_inventory)},
                                                   {"settings", tolerant(read_settings)},
                                                   {"experiment", tolerant(read_experiment)},
                                                   {"network", tolerant(read_network)},
                                                   {"trajectory", tolerant(read_trajectory)},
                                                   {"relations", tolerant(read_relation_file)}};
    return all;
}

}  // namespace ddtool::fuzz

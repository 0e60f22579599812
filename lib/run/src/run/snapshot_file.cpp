#include "run/snapshot_file.hpp"

#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/messages/ros_codec.hpp"

namespace ddtool {
namespace {

constexpr const char* snapshot_topic = "/particle_snapshots";

RosPose2D to_message(const Pose2& pose) { return {pose.x_m, pose.y_m, pose.theta_rad}; }
Pose2 from_message(const RosPose2D& pose) { return {pose.x, pose.y, pose.theta}; }

RosSnapshotParticle to_message(const SnapshotParticle& particle) {
    return {to_message(particle.pose),
            to_message(particle.matched_motion),
            to_message(particle.predicted_motion),
            particle.log_likelihood,
            particle.log_likelihood_increment,
            particle.match_score,
            particle.weight};
}

SnapshotParticle from_message(const RosSnapshotParticle& particle) {
    return {from_message(particle.pose),
            from_message(particle.matched_motion),
            from_message(particle.predicted_motion),
            particle.log_likelihood,
            particle.log_likelihood_increment,
            particle.match_score,
            particle.weight};
}

RecordedSnapshot from_message(const RosParticleSnapshot& message) {
    RecordedSnapshot recorded{{message.stamp.ns, message.update, from_message(message.odometry_motion), {}},
                              {message.degeneracy}};
    for (const RosSnapshotParticle& particle : message.particles) {
        recorded.snapshot.particles.push_back(from_message(particle));
    }
    return recorded;
}

}  // namespace

void SnapshotWriter::write(const ParticleSnapshot& snapshot, const Degeneracy& degeneracy) {
    RosParticleSnapshot message{
        {snapshot.stamp_ns}, snapshot.update, to_message(snapshot.odometry_motion), degeneracy.degree, {}};
    for (const SnapshotParticle& particle : snapshot.particles) {
        message.particles.push_back(to_message(particle));
    }
    file_.write(snapshot_topic, snapshot.stamp_ns, message);
}

SnapshotReader::SnapshotReader(const std::filesystem::path& path, LogProblemHandler on_problem)
    : file_(path.string()), on_problem_(std::move(on_problem)), reader_(path, on_problem_) {}

std::optional<RecordedSnapshot> SnapshotReader::next() {
    while (const auto message = reader_.next()) {
        const std::string& type = message->channel->schema.name;
        if (type != RosParticleSnapshot::type_name) {
            throw Error(file_ + ": topic " + message->channel->topic + " has " + type + "; expected " +
                        RosParticleSnapshot::type_name);
        }
        if (const auto decoded = decode_cdr<RosParticleSnapshot>(message->data)) {
            return from_message(*decoded);
        }
        on_problem_({file_ + ": a damaged snapshot near byte " + std::to_string(message->file_offset),
                     message->file_offset, message->data.size()});
    }
    return std::nullopt;
}

}  // namespace ddtool

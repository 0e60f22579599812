#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

#include "ddtool/swarm/degeneracy_detector.hpp"
#include "ddtool/swarm/particle_snapshot.hpp"
#include "logs/containers/mcap_reader.hpp"
#include "logs/stream/ros2_writer.hpp"

namespace ddtool {

/// A swarm and what the detector made of it when the filter ran.
struct RecordedSnapshot {
    ParticleSnapshot snapshot;
    Degeneracy degeneracy;
};

/// Writes snapshots as an MCAP file (docs/formats/snapshots.md), one at a time.
class SnapshotWriter {
public:
    explicit SnapshotWriter(const std::filesystem::path& path) : file_(path) {}

    void write(const ParticleSnapshot& snapshot, const Degeneracy& degeneracy);
    /// Completes the file; without it nothing is left behind.
    void close() { file_.close(); }

private:
    Ros2Writer file_;
};

/// Reads them back, one at a time.
class SnapshotReader {
public:
    /// Damage goes to the handler and reading goes on. Throws Error for what is not an MCAP file.
    SnapshotReader(const std::filesystem::path& path, LogProblemHandler on_problem);

    /// The next snapshot, none at the end. Throws Error, naming the file, for a message of another kind.
    std::optional<RecordedSnapshot> next();
    /// Share of the file read, 0..1.
    [[nodiscard]] double fraction_read() const { return reader_.fraction_read(); }

private:
    std::string file_;
    LogProblemHandler on_problem_;
    McapReader reader_;
};

}  // namespace ddtool

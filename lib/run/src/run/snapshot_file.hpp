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

/// A swarm and the detector's result for it, as recorded while the filter ran.
struct RecordedSnapshot {
    ParticleSnapshot snapshot;
    Degeneracy degeneracy;
};

/// Writes snapshots as an MCAP file (docs/formats/snapshots.md), one at a time.
class SnapshotWriter {
public:
    explicit SnapshotWriter(const std::filesystem::path& path) : file_(path) {}

    void write(const ParticleSnapshot& snapshot, const Degeneracy& degeneracy);
    /// Completes the file. If this is never called, no file is left behind.
    void close() { file_.close(); }

private:
    Ros2Writer file_;
};

/// Reads the snapshots of such a file, one at a time.
class SnapshotReader {
public:
    /// Damaged parts are reported to the handler, and reading continues behind them. Throws Error if the file is not an
    /// MCAP file.
    SnapshotReader(const std::filesystem::path& path, LogProblemHandler on_problem);

    /// Returns the next snapshot, or nullopt at the end of the file. Throws Error that names the file if it holds
    /// messages of another type.
    std::optional<RecordedSnapshot> next();
    /// Returns the share of the file that has been read, in 0..1.
    [[nodiscard]] double fraction_read() const { return reader_.fraction_read(); }

private:
    std::string file_;
    LogProblemHandler on_problem_;
    McapReader reader_;
};

}  // namespace ddtool

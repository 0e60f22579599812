#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "ddtool/logs/log_problem.hpp"
#include "logs/containers/byte_source.hpp"

namespace ddtool {

/// Where the bytes of a log are: in a file, or in a file of a tar archive. Either may be compressed.
struct LogFile {
    std::filesystem::path path;
    std::string entry;  ///< its name in the archive `path`; empty: the file itself

    /// For messages: "logs/a.bag", "logs/a.tar.gz/a.bag".
    [[nodiscard]] std::string name() const { return path.string() + (entry.empty() ? "" : "/" + entry); }
};

/// A file may be compressed again by a backup or an upload. More layers than this are no log that somebody packed.
inline constexpr int most_layers = 4;

/// The bytes of a log, decompressed if they are gzip, bzip2, zstd or lz4 by their first bytes, also if they are so
/// several times, up to most_layers. Throws Error naming the
/// file if it cannot be opened, or if the archive has no such entry. If the data are cut off or damaged, they end
/// there, which is reported.
ByteSource open_bytes(const LogFile& file, const LogProblemHandler& on_problem);

/// Calls `visit` with each regular file in a tar archive, which may itself be compressed, and with the first bytes of
/// its content, decompressed if it is compressed, too. The archive is read once. Damage is not reported.
void visit_archive(const std::filesystem::path& path,
                   const std::function<void(const LogFile&, std::span<const std::byte>)>& visit);

}  // namespace ddtool

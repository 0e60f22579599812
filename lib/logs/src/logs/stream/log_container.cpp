#include "logs/stream/log_container.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/bag_reader.hpp"
#include "logs/containers/compression.hpp"
#include "logs/containers/db3_source.hpp"
#include "logs/containers/file_kind.hpp"
#include "logs/containers/mcap_message_source.hpp"
#include "logs/containers/rosbag2_folder.hpp"
#include "logs/containers/rosbag2_source.hpp"
#include "logs/containers/tar_reader.hpp"
#include "logs/containers/temporary_copy.hpp"
#include "logs/containers/zstd_messages.hpp"
#include "logs/messages/carmen_message.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

constexpr std::size_t head_bytes = 1 << 16;

/// Throws Error saying why if not even the first bytes can be decompressed.
std::string head_of(const LogFile& file) {
    std::string damage;
    ByteSource bytes = open_bytes(file, [&](const LogProblem& problem) { damage = problem.what; });
    const std::span<const std::byte> start = bytes.start(head_bytes);
    if (start.empty() && !damage.empty()) {
        throw Error(damage + "; nothing before that could be decompressed");
    }
    return {reinterpret_cast<const char*>(start.data()), start.size()};
}

std::optional<LogContainer> container_of_head(std::string_view head) {
    if (head.starts_with(mcap_start)) {
        return LogContainer::mcap;
    }
    if (head.starts_with(bag_start)) {
        return LogContainer::ros1_bag;
    }
    if (head.starts_with(sqlite_magic)) {
        return LogContainer::db3;
    }
    return looks_like_carmen(head) ? std::optional(LogContainer::carmen) : std::nullopt;
}

std::string archived_names(const std::vector<LogFile>& files) {
    constexpr std::size_t most_named = 4;
    std::string names;
    for (std::size_t i = 0; i < std::min(files.size(), most_named); ++i) {
        names += (i == 0 ? "" : ", ") + files[i].entry;
    }
    return names + (files.size() > most_named ? ", ..." : "");
}

FoundLog find_in_archive(const std::filesystem::path& path) {
    std::vector<LogFile> logs;
    std::vector<LogFile> metadata;
    std::vector<LogFile> others;
    bool are_storage = true;
    LogContainer container = LogContainer::mcap;
    visit_archive(path, [&](const LogFile& file, std::span<const std::byte> start) {
        const std::string_view head(reinterpret_cast<const char*>(start.data()), start.size());
        if (const auto kind = container_of_head(head)) {
            container = *kind;
            are_storage = are_storage && (kind == LogContainer::mcap || kind == LogContainer::db3);
            logs.push_back(file);
        } else {
            (is_rosbag2_metadata(head) ? metadata : others).push_back(file);
        }
    });
    if (logs.empty()) {
        throw Error(path.string() + ": is a tar archive without a log; it has " +
                    (others.empty() ? "no other files" : archived_names(others)));
    }
    if (logs.size() == 1) {
        return {container, path, logs};
    }
    const auto folder = [](const LogFile& file) { return std::filesystem::path(file.entry).parent_path(); };
    const bool is_recording = are_storage && metadata.size() < 2 &&
                              (!metadata.empty() || are_parts_of_one_recording(logs)) &&
                              std::ranges::all_of(logs, [&](const LogFile& file) {
                                  return folder(file) == folder(metadata.empty() ? logs.front() : metadata.front());
                              });
    if (!is_recording) {
        throw Error(path.string() + ": is a tar archive with " + std::to_string(logs.size()) + " logs (" +
                    archived_names(logs) + "); unpack it (`tar -xf FILE`) and give one of them");
    }
    return {LogContainer::rosbag2_folder, path,
            rosbag2_files(logs, metadata.empty() ? LogFile{path, ""} : metadata[0])};
}

std::unique_ptr<MessageSource> unpacked(std::unique_ptr<MessageSource> source, const LogFile& file,
                                        LogProblemHandler on_problem) {
    return std::make_unique<ZstdMessages>(std::move(source), file.name(), std::move(on_problem));
}

std::unique_ptr<MessageSource> open_file(LogContainer container, const LogFile& file,
                                         const LogProblemHandler& on_problem);

std::unique_ptr<MessageSource> open_storage_file(const LogFile& file, const LogProblemHandler& on_problem) {
    const std::string head = head_of(file);
    const auto container = container_of_head(head);
    if (container != LogContainer::mcap && container != LogContainer::db3) {
        throw Error(file.name() + ": " + describe_file_start(std::as_bytes(std::span(head))) +
                    " in a rosbag2 folder; expected MCAP or .db3");
    }
    return open_file(*container, file, on_problem);
}

/// SQLite reads only files, so that a database that is compressed or in an archive is copied first.
std::unique_ptr<MessageSource> open_database(const LogFile& file, const LogProblemHandler& on_problem) {
    ByteSource raw(file.path);
    if (file.entry.empty() && compression_of_start(raw.start(4)) == Compression::none) {
        return std::make_unique<Db3Source>(file.path, file.name(), on_problem);
    }
    TemporaryCopy copy(open_bytes(file, on_problem));
    return std::make_unique<Db3Source>(copy.path(), file.name(), on_problem);  // which keeps the copy open
}

std::unique_ptr<MessageSource> open_file(LogContainer container, const LogFile& file,
                                         const LogProblemHandler& on_problem) {
    switch (container) {
        case LogContainer::mcap:
            return unpacked(std::make_unique<McapMessageSource>(open_bytes(file, on_problem), on_problem), file,
                            on_problem);
        case LogContainer::ros1_bag:
            return std::make_unique<BagReader>(file, on_problem);
        case LogContainer::db3:
            return unpacked(open_database(file, on_problem), file, on_problem);
        case LogContainer::rosbag2_folder:
        case LogContainer::carmen:
            break;
    }
    throw Error(file.name() + ": a CARMEN log has no messages of ROS or Foxglove");
}

}  // namespace

std::string_view name_of(LogContainer container) {
    switch (container) {
        case LogContainer::mcap:
            return "MCAP";
        case LogContainer::ros1_bag:
            return "ROS 1 bag";
        case LogContainer::db3:
            return "rosbag2 database";
        case LogContainer::rosbag2_folder:
            return "rosbag2 folder";
        case LogContainer::carmen:
            break;
    }
    return "CARMEN";
}

FoundLog find_log(const std::filesystem::path& path) {
    if (is_folder(path)) {
        return {LogContainer::rosbag2_folder, path, {}};
    }
    const LogFile file{path, ""};
    const std::string head = head_of(file);
    const auto bytes = std::as_bytes(std::span(head));
    if (is_tar(bytes)) {  // before the rest: an archive that is not compressed shows the text of a log in it
        return find_in_archive(path);
    }
    if (const auto container = container_of_head(head)) {
        return {*container, path, {file}};
    }
    if (is_rosbag2_metadata(head)) {
        const std::filesystem::path folder = path.parent_path();
        return {LogContainer::rosbag2_folder, folder.empty() ? "." : folder, {}};
    }
    if (compression_of_start(bytes) != Compression::none) {
        throw Error(path.string() + ": is compressed more than " + std::to_string(most_layers) +
                    " times; unpack it and give the log in it");
    }
    throw Error(path.string() + ": " + describe_file_start(bytes) +
                "; expected MCAP, a ROS 1 bag, rosbag2 (.db3 or its folder) or a CARMEN log (also compressed, or in a "
                "tar archive)");
}

std::unique_ptr<MessageSource> open_messages(const FoundLog& log, LogProblemHandler on_problem) {
    if (log.container == LogContainer::rosbag2_folder) {
        const auto open = [on_problem](const LogFile& file) { return open_storage_file(file, on_problem); };
        return std::make_unique<Rosbag2Source>(log.files.empty() ? rosbag2_files(log.path, on_problem) : log.files,
                                               open, on_problem);
    }
    return open_file(log.container, log.files.front(), on_problem);
}

LineReader open_lines(const FoundLog& log, const LogProblemHandler& on_problem) {
    return LineReader(open_bytes(log.files.front(), on_problem));
}

}  // namespace ddtool

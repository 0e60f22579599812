#include "logs/stream/log_container.hpp"

#include <span>
#include <string>
#include <utility>

#include "ddtool/base/error.hpp"
#include "logs/containers/bag_reader.hpp"
#include "logs/containers/db3_source.hpp"
#include "logs/containers/file_kind.hpp"
#include "logs/containers/mcap_message_source.hpp"
#include "logs/containers/rosbag2_source.hpp"
#include "logs/containers/text_source.hpp"
#include "logs/containers/zstd_messages.hpp"
#include "logs/messages/carmen_message.hpp"
#include "system/folder.hpp"

namespace ddtool {
namespace {

constexpr std::size_t head_bytes = 1 << 16;

std::string read_head(const std::filesystem::path& path) {
    std::string head(head_bytes, '\0');
    head.resize(open_text(path, [](const LogProblem&) {})->read(head));
    return head;
}

std::unique_ptr<MessageSource> unpacked(std::unique_ptr<MessageSource> source, const std::filesystem::path& path,
                                        LogProblemHandler on_problem) {
    return std::make_unique<ZstdMessages>(std::move(source), path.string(), std::move(on_problem));
}

std::unique_ptr<MessageSource> open_storage_file(const std::filesystem::path& path, LogProblemHandler on_problem) {
    const LogContainer container = container_of(path);
    if (container != LogContainer::mcap && container != LogContainer::db3) {
        throw Error(path.string() + ": is a " + std::string(name_of(container)) +
                    " in a rosbag2 folder; expected MCAP or .db3");
    }
    return open_messages(container, path, std::move(on_problem));
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

LogContainer container_of(const std::filesystem::path& path) {
    if (is_folder(path)) {
        return LogContainer::rosbag2_folder;
    }
    const std::string head = read_head(path);
    if (head.starts_with(mcap_start)) {
        return LogContainer::mcap;
    }
    if (head.starts_with(bag_start)) {
        return LogContainer::ros1_bag;
    }
    if (head.starts_with(sqlite_magic)) {
        return LogContainer::db3;
    }
    if (looks_like_carmen(head)) {
        return LogContainer::carmen;
    }
    throw Error(
        path.string() + ": " + describe_file_start(std::as_bytes(std::span(head))) +
        "; expected MCAP, a ROS 1 bag, rosbag2 (.db3 or its folder) or a CARMEN log (text, also gzip or bzip2)");
}

std::unique_ptr<MessageSource> open_messages(LogContainer container, const std::filesystem::path& path,
                                             LogProblemHandler on_problem) {
    switch (container) {
        case LogContainer::mcap:
            return unpacked(std::make_unique<McapMessageSource>(path, on_problem), path, on_problem);
        case LogContainer::ros1_bag:
            return std::make_unique<BagReader>(path, std::move(on_problem));
        case LogContainer::db3:
            return unpacked(std::make_unique<Db3Source>(path, on_problem), path, on_problem);
        case LogContainer::rosbag2_folder: {
            const auto open = [on_problem](const std::filesystem::path& file) {
                return open_storage_file(file, on_problem);
            };
            return std::make_unique<Rosbag2Source>(path, open, on_problem);
        }
        case LogContainer::carmen:
            break;
    }
    throw Error(path.string() + ": a CARMEN log has no messages of ROS or Foxglove");
}

}  // namespace ddtool

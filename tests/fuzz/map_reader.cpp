#include <array>
#include <filesystem>

#include "input_file.hpp"
#include "logs/containers/mcap_writer.hpp"
#include "logs/messages/ros2_schema.hpp"
#include "map_messages.hpp"
#include "maps/map_file.hpp"
#include "readers.hpp"
#include "temporary_folder.hpp"

namespace ddtool::fuzz {
namespace {

void use(const std::filesystem::path& file) {
    (void)maps::graph_of(maps::read_map(file));
    (void)maps::read_map(file, maps::MapParts::grid);
}

}  // namespace

void read_map_file(std::span<const char> content) { use(input_file(content, "map.ddmap")); }

/// Takes the input for the messages of a map file and puts them into one whose checksums are right. Otherwise the
/// checksums would keep every change away from what is behind them.
void read_map_messages(std::span<const char> content) {
    static const test::TemporaryFolder folder;
    const std::filesystem::path file = folder / "map.ddmap";
    McapWriter writer(file, {.profile = "ros2", .compression = Compression::none});
    std::array<std::uint16_t, map_messages.size()> channels{};
    for (std::size_t i = 0; i < channels.size(); ++i) {
        const MapMessage& message = map_messages.at(i);
        channels.at(i) = writer.add_channel(message.topic, "cdr", message.type, "ros2msg", ros2_schema(message.type));
    }
    const auto byte = [&](std::size_t at) { return static_cast<unsigned char>(content[at]); };
    while (content.size() >= map_message_head_bytes) {
        const std::size_t length =
            std::min<std::size_t>(byte(1) + 256U * byte(2), content.size() - map_message_head_bytes);
        writer.write(channels.at(byte(0) % channels.size()), 1,
                     std::as_bytes(content.subspan(map_message_head_bytes, length)));
        content = content.subspan(map_message_head_bytes + length);
    }
    writer.close();
    use(file);
}

}  // namespace ddtool::fuzz

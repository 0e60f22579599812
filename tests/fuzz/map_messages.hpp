#pragma once

#include <array>
#include <cstddef>

namespace ddtool::fuzz {

struct MapMessage {
    const char* topic;
    const char* type;
};

/// The messages of a map file. An input of messages has for each of them its number in this list (one byte), its length
/// (two bytes, the lower first) and its content.
inline constexpr std::array<MapMessage, 6> map_messages{{
    {"/map/header", "ddtool_msgs/msg/MapHeader"},
    {"/map/scan", "ddtool_msgs/msg/MapScan"},
    {"/map/drive", "ddtool_msgs/msg/MapDrive"},
    {"/map/graph", "ddtool_msgs/msg/MapGraph"},
    {"/map/tile", "ddtool_msgs/msg/MapTile"},
    {"/map/end", "ddtool_msgs/msg/MapEnd"},
}};
inline constexpr std::size_t map_message_head_bytes = 3;

}  // namespace ddtool::fuzz

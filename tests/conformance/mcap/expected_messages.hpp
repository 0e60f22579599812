#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "ddtool/system/settings.hpp"
#include "mcap_read_back.hpp"
#include "system/atomic_file.hpp"

namespace ddtool::test {

inline Json read_json(const std::filesystem::path& file) { return Json::parse(read_file(file)); }

inline std::string unhex(const std::string& hex) {
    std::string bytes;
    for (std::size_t at = 0; at < hex.size(); at += 2) {
        bytes += static_cast<char>(std::stoi(hex.substr(at, 2), nullptr, 16));
    }
    return bytes;
}

/// The channel without its ids, because each writer chooses ids of its own.
inline McapChannel channel_of(const Json& json) {
    const Json& schema = json.at("schema");
    return {0,
            json.at("topic"),
            json.at("messageEncoding"),
            json.at("metadata"),
            {0, schema.at("name"), schema.at("encoding"), schema.at("data")}};
}

/// The messages in an expected.json that make_samples.mjs wrote.
inline std::vector<OwnedMessage> expected_messages(const std::filesystem::path& file) {
    const Json expected = read_json(file);
    std::map<std::string, McapChannel> channels;
    for (const Json& json : expected.at("channels")) {
        channels[json.at("topic")] = channel_of(json);
    }
    std::vector<OwnedMessage> messages;
    for (const Json& json : expected.at("messages")) {
        messages.push_back({channels.at(json.at("topic")), json.at("sequence"),
                            std::stoll(json.at("logTime").get<std::string>()),
                            std::stoll(json.at("publishTime").get<std::string>()), unhex(json.at("data"))});
    }
    return messages;
}

/// The content of a file in the form of expected_messages(), so that the two can be compared.
inline ReadBack read_back_without_ids(const std::filesystem::path& file) {
    ReadBack result = read_back(ByteSource(file));
    for (OwnedMessage& message : result.messages) {
        message.channel.id = 0;
        message.channel.schema.id = 0;
    }
    return result;
}

}  // namespace ddtool::test

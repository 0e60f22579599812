#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "logs/containers/message_source.hpp"
#include "logs/messages/ros_codec.hpp"
#include "logs/messages/ros_conversions.hpp"

namespace ddtool::test {

/// A log of messages in memory.
class MessageLog {
public:
    template <typename Message>
    MessageLog& add(const std::string& topic, std::int64_t stamp_ns, const Message& message) {
        return add_bytes(topic, "cdr", Message::type_name, stamp_ns, encode_cdr(message));
    }
    MessageLog& add_bytes(const std::string& topic, const std::string& encoding, const std::string& type,
                          std::int64_t stamp_ns, std::vector<std::byte> data) {
        McapChannel& channel = channels_[topic];
        channel.topic = topic;
        channel.message_encoding = encoding;
        channel.schema.name = type;
        messages_.push_back({&channel, stamp_ns, std::move(data)});
        return *this;
    }

    class Source : public MessageSource {
    public:
        explicit Source(const MessageLog& log) : log_(log) {}
        std::optional<McapMessage> next() override {
            if (at_ == log_.messages_.size()) {
                return std::nullopt;
            }
            const Stored& stored = log_.messages_[at_++];
            return McapMessage{stored.channel, 0, stored.stamp_ns, stored.stamp_ns, stored.data, at_};
        }
        [[nodiscard]] double fraction_read() const override {
            return static_cast<double>(at_) / static_cast<double>(log_.messages_.size());
        }

    private:
        const MessageLog& log_;
        std::size_t at_ = 0;
    };

    /// The source must not outlive the log.
    [[nodiscard]] std::unique_ptr<MessageSource> open() const { return std::make_unique<Source>(*this); }

private:
    struct Stored {
        const McapChannel* channel;
        std::int64_t stamp_ns;
        std::vector<std::byte> data;
    };
    std::map<std::string, McapChannel> channels_;
    std::deque<Stored> messages_;
};

}  // namespace ddtool::test

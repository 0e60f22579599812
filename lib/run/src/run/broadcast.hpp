#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/client_links.hpp"
#include "run/foxglove_protocol.hpp"

namespace ddtool {

struct LiveMessage {
    std::string topic;
    std::string type_name;
    std::int64_t stamp_ns = 0;
    std::vector<std::byte> data;  ///< CDR
};

/// Who gets what: the Foxglove protocol without the network. Of each topic the latest message is kept. A subscriber
/// gets it at once, and all that follow as long as he reads; who is slow misses messages, but gets the latest of each
/// topic as soon as he has read what waits. So a client never holds more memory than backlog_bytes and one message.
/// For one thread.
class Broadcast {
public:
    static constexpr std::size_t backlog_bytes = std::size_t{1} << 20;

    /// The links must outlive it.
    Broadcast(ClientLinks& links, std::string session);

    void publish(std::shared_ptr<const LiveMessage> message);

    void opened(ClientId client);
    void closed(ClientId client);
    void received(ClientId client, const std::string& payload, bool is_text);

    /// Sends those who were slow what they miss, where they have read on.
    void catch_up();

private:
    using ChannelId = std::uint32_t;
    /// What one client wants.
    struct Wishes {
        std::map<ChannelId, std::uint32_t> subscriptions;  ///< to their ids
        std::deque<ChannelId> behind;                      ///< channels whose latest he lacks, longest first
    };

    ChannelId channel_of(const LiveMessage& message);
    [[nodiscard]] bool has_room(ClientId client) const;
    void tell_time(std::int64_t stamp_ns);
    void owe(ClientId client, Wishes& wishes, ChannelId channel);
    void pay(ClientId client, Wishes& wishes);
    void send_latest(ClientId client, const Wishes& wishes, ChannelId channel);
    void subscribe(ClientId client, const foxglove::Subscription& wanted);
    void unsubscribe(ClientId client, std::uint32_t subscription);
    void complain(ClientId client, const std::string& text);

    ClientLinks& links_;
    std::string session_;
    std::vector<foxglove::Channel> channels_;  ///< by their ids
    std::vector<std::shared_ptr<const LiveMessage>> latest_;
    std::optional<std::int64_t> time_ns_;
    std::map<ClientId, Wishes> clients_;
};

}  // namespace ddtool

#pragma once

#include <chrono>
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
#include "run/message_history.hpp"

namespace ddtool {

/// Decides which client gets which message: the Foxglove protocol without the network. The latest message of each topic
/// is kept. A subscriber gets it at once, and then every later message as long as they read fast enough. A slow
/// subscriber misses messages, but gets the latest of each topic as soon as they have read what is waiting for them. So
/// a client never occupies more memory than backlog_bytes, one message and the history. Not thread-safe: use it from
/// one thread only.
///
/// Of /degeneracy the whole history is kept, so that a viewer who comes late can draw the degree of the whole run. A
/// viewer places a message where the server's clock is when it comes. So the clock is set back to the first of them,
/// stands there for `rewound_for`, and goes with them to the present. Viewers begin their plots at the earliest time at
/// which they have looked at the clock, once per picture: without the wait that would be somewhere in the history, or
/// behind it. They forget what they have when the clock is set back, so that they get nothing else meanwhile, and the
/// latest messages of all their topics at the end. A new client's clock begins there, too, since most subscribe at
/// once.
class Broadcast {
public:
    using Clock = std::chrono::steady_clock;

    static constexpr std::size_t backlog_bytes = std::size_t{1} << 20;
    static constexpr std::chrono::milliseconds rewound_for{1000};

    /// `links` must outlive this object.
    Broadcast(ClientLinks& links, std::string session);

    void publish(std::shared_ptr<const LiveMessage> message);

    void opened(ClientId client);
    void closed(ClientId client);
    void received(ClientId client, const std::string& payload, bool is_text);

    /// Sends slow clients that have meanwhile read on the latest messages that they missed, and histories whose time
    /// has come. To be called every few dozen milliseconds.
    void catch_up(Clock::time_point now);

private:
    using ChannelId = std::uint32_t;
    /// A client whose clock stands at the beginning of the history of a channel.
    struct Rewound {
        ChannelId channel = 0;
        std::optional<Clock::time_point> since;  ///< of the next call of catch_up()
    };
    /// What one client has subscribed to.
    struct Wishes {
        std::map<ChannelId, std::uint32_t> subscriptions;  ///< the subscription's id by channel
        std::deque<ChannelId> behind;                      ///< channels whose latest message they lack, oldest first
        std::optional<Rewound> rewound;
    };

    ChannelId channel_of(const LiveMessage& message);
    [[nodiscard]] bool has_room(ClientId client) const;
    void tell_time(std::int64_t stamp_ns);
    void owe(ClientId client, Wishes& wishes, ChannelId channel);
    void pay(ClientId client, Wishes& wishes);
    void send(ClientId client, const Wishes& wishes, ChannelId channel, const LiveMessage& message);
    /// Sets the client's clock back to the first message of a channel, if it has a history and the client has room.
    bool rewind(ClientId client, Wishes& wishes, ChannelId channel);
    /// Sends the history for which the client's clock was set back, and sets its clock to the present.
    void send_history(ClientId client, Wishes& wishes);
    void subscribe(ClientId client, const FoxgloveSubscription& wanted);
    void unsubscribe(ClientId client, std::uint32_t subscription);
    void complain(ClientId client, const std::string& text);

    ClientLinks& links_;
    std::string session_;
    std::vector<FoxgloveChannel> channels_;  ///< by their ids
    std::vector<std::shared_ptr<const LiveMessage>> latest_;
    std::map<ChannelId, MessageHistory> histories_;
    std::optional<std::int64_t> time_ns_;
    std::map<ClientId, Wishes> clients_;
};

}  // namespace ddtool

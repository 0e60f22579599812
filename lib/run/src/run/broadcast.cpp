#include "run/broadcast.hpp"

#include <algorithm>
#include <utility>

#include "ddtool/base/error.hpp"

namespace ddtool {
namespace {

constexpr const char* topic_with_history = "/degeneracy";

}  // namespace

Broadcast::Broadcast(ClientLinks& links, std::string session) : links_(links), session_(std::move(session)) {}

void Broadcast::publish(std::shared_ptr<const LiveMessage> message) {
    const ChannelId channel = channel_of(*message);
    tell_time(message->stamp_ns);
    if (message->topic == topic_with_history) {
        histories_[channel].add(message);
    }
    latest_[channel] = std::move(message);
    for (auto& [client, wishes] : clients_) {
        if (wishes.subscriptions.contains(channel)) {
            owe(client, wishes, channel);
        }
    }
}

void Broadcast::opened(ClientId client) {
    Wishes& wishes = clients_[client];
    links_.send_text(client, foxglove_server_info("ddtool slam", session_));
    links_.send_text(client, foxglove_advertisement(channels_));
    if (!histories_.empty()) {
        rewind(client, wishes, histories_.begin()->first);
    } else if (time_ns_) {
        links_.send_binary(client, foxglove_time_message(*time_ns_));
    }
}

void Broadcast::closed(ClientId client) { clients_.erase(client); }

void Broadcast::received(ClientId client, const std::string& payload, bool is_text) {
    try {
        if (!is_text) {
            throw Error("a binary message; expected subscribe or unsubscribe as text");
        }
        const FoxgloveRequest request = parse_foxglove_request(payload);
        for (const FoxgloveSubscription& wanted : request.subscribe) {
            subscribe(client, wanted);
        }
        for (const std::uint32_t subscription : request.unsubscribe) {
            unsubscribe(client, subscription);
        }
    } catch (const Error& error) {
        complain(client, error.what());
    }
}

void Broadcast::catch_up(Clock::time_point now) {
    for (auto& [client, wishes] : clients_) {
        if (wishes.rewound) {
            wishes.rewound->since = wishes.rewound->since.value_or(now);
            if (now - *wishes.rewound->since >= rewound_for) {
                send_history(client, wishes);
            }
        }
        pay(client, wishes);
    }
}

Broadcast::ChannelId Broadcast::channel_of(const LiveMessage& message) {
    const auto known = std::find_if(channels_.begin(), channels_.end(),
                                    [&](const FoxgloveChannel& each) { return each.topic == message.topic; });
    if (known != channels_.end()) {
        return known->id;
    }
    channels_.push_back({static_cast<ChannelId>(channels_.size()), message.topic, message.type_name});
    latest_.emplace_back();
    for (const auto& [client, wishes] : clients_) {
        links_.send_text(client, foxglove_advertisement({&channels_.back(), 1}));
    }
    return channels_.back().id;
}

bool Broadcast::has_room(ClientId client) const { return links_.unsent_bytes(client) < backlog_bytes; }

void Broadcast::tell_time(std::int64_t stamp_ns) {
    if (time_ns_ == stamp_ns) {
        return;
    }
    time_ns_ = stamp_ns;
    const std::string message = foxglove_time_message(stamp_ns);
    for (const auto& [client, wishes] : clients_) {
        if (!wishes.rewound && has_room(client)) {
            links_.send_binary(client, message);
        }
    }
}

void Broadcast::owe(ClientId client, Wishes& wishes, ChannelId channel) {
    if (std::find(wishes.behind.begin(), wishes.behind.end(), channel) == wishes.behind.end()) {
        wishes.behind.push_back(channel);
    }
    pay(client, wishes);
}

void Broadcast::pay(ClientId client, Wishes& wishes) {
    while (!wishes.rewound && !wishes.behind.empty() && has_room(client)) {
        send(client, wishes, wishes.behind.front(), *latest_[wishes.behind.front()]);
        wishes.behind.pop_front();
    }
}

bool Broadcast::rewind(ClientId client, Wishes& wishes, ChannelId channel) {
    const auto history = histories_.find(channel);
    if (history == histories_.end() || !has_room(client)) {
        return false;
    }
    wishes.rewound = Rewound{.channel = channel, .since = std::nullopt};
    links_.send_binary(client, foxglove_time_message(history->second.first_stamp_ns()));
    return true;
}

void Broadcast::send_history(ClientId client, Wishes& wishes) {
    const ChannelId channel = wishes.rewound->channel;
    wishes.rewound.reset();
    std::erase(wishes.behind, channel);
    if (wishes.subscriptions.contains(channel)) {
        for (const std::shared_ptr<const LiveMessage>& message : histories_.at(channel).messages()) {
            links_.send_binary(client, foxglove_time_message(message->stamp_ns));
            send(client, wishes, channel, *message);
        }
    }
    links_.send_binary(client, foxglove_time_message(*time_ns_));
    for (const auto& [other, subscription] : wishes.subscriptions) {
        if (other != channel) {
            owe(client, wishes, other);
        }
    }
}

void Broadcast::send(ClientId client, const Wishes& wishes, ChannelId channel, const LiveMessage& message) {
    links_.send_binary(client, foxglove_data_message(wishes.subscriptions.at(channel), message.stamp_ns, message.data));
}

void Broadcast::subscribe(ClientId client, const FoxgloveSubscription& wanted) {
    Wishes& wishes = clients_.at(client);
    if (wanted.channel >= channels_.size()) {
        return complain(client, "subscribe: there is no channel " + std::to_string(wanted.channel));
    }
    const bool id_is_used = std::any_of(wishes.subscriptions.begin(), wishes.subscriptions.end(),
                                        [&](const auto& each) { return each.second == wanted.id; });
    if (id_is_used || wishes.subscriptions.contains(wanted.channel)) {
        return complain(client, "subscribe: subscription " + std::to_string(wanted.id) + " or channel " +
                                    std::to_string(wanted.channel) + " is in use");
    }
    wishes.subscriptions.emplace(wanted.channel, wanted.id);
    if (!rewind(client, wishes, wanted.channel)) {
        owe(client, wishes, wanted.channel);
    }
}

void Broadcast::unsubscribe(ClientId client, std::uint32_t subscription) {
    Wishes& wishes = clients_.at(client);
    const auto found = std::find_if(wishes.subscriptions.begin(), wishes.subscriptions.end(),
                                    [&](const auto& each) { return each.second == subscription; });
    if (found == wishes.subscriptions.end()) {
        return complain(client, "unsubscribe: there is no subscription " + std::to_string(subscription));
    }
    std::erase(wishes.behind, found->first);
    wishes.subscriptions.erase(found);
}

/// Sends an error message to the client. A client that does not read gets none, because its messages would pile up.
void Broadcast::complain(ClientId client, const std::string& text) {
    if (has_room(client)) {
        links_.send_text(client, foxglove_status(FoxgloveStatusLevel::error, text));
    }
}

}  // namespace ddtool

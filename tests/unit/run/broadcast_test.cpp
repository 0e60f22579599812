#include "run/broadcast.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <numeric>
#include <random>
#include <set>

#include "ddtool/system/settings.hpp"

namespace ddtool {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::IsEmpty;

/// Records what each client would receive. Clients that are marked as slow read nothing.
class RecordingLinks : public ClientLinks {
public:
    void send_text(ClientId client, const std::string& text) override {
        texts[client].push_back(Json::parse(text));
        unsent[client] += slow.contains(client) ? text.size() : 0;
    }
    void send_binary(ClientId client, const std::string& bytes) override {
        (bytes[0] == 1 ? data : times)[client].push_back(bytes);
        unsent[client] += slow.contains(client) ? bytes.size() : 0;
    }
    [[nodiscard]] std::size_t unsent_bytes(ClientId client) const override {
        return unsent.contains(client) ? unsent.at(client) : 0;
    }

    std::map<ClientId, std::vector<Json>> texts;
    std::map<ClientId, std::vector<std::string>> data;
    std::map<ClientId, std::vector<std::string>> times;
    std::map<ClientId, std::size_t> unsent;
    std::set<ClientId> slow;
};

class BroadcastTest : public testing::Test {
protected:
    void publish(const std::string& topic, std::int64_t stamp_ns, std::size_t size = 4) {
        broadcast_.publish(std::make_shared<const LiveMessage>(
            LiveMessage{topic, "nav_msgs/msg/Path", stamp_ns, std::vector<std::byte>(size)}));
    }
    void subscribe(ClientId client, std::uint32_t id, std::uint32_t channel) {
        const Json request{{"op", "subscribe"}, {"subscriptions", {{{"id", id}, {"channelId", channel}}}}};
        broadcast_.received(client, request.dump(), true);
    }
    void unsubscribe(ClientId client, std::uint32_t id) {
        broadcast_.received(client, Json{{"op", "unsubscribe"}, {"subscriptionIds", {id}}}.dump(), true);
    }
    /// The stamps of the messages that a client was sent for a subscription.
    std::vector<std::int64_t> stamps(ClientId client, std::uint32_t subscription) {
        std::vector<std::int64_t> found;
        for (const std::string& message : links_.data[client]) {
            std::uint32_t id = 0;
            std::int64_t stamp_ns = 0;
            std::memcpy(&id, message.data() + 1, sizeof(id));
            std::memcpy(&stamp_ns, message.data() + 5, sizeof(stamp_ns));
            if (id == subscription) {
                found.push_back(stamp_ns);
            }
        }
        return found;
    }

    /// The times that a client was told.
    std::vector<std::int64_t> times(ClientId client) {
        std::vector<std::int64_t> told;
        for (const std::string& message : links_.times[client]) {
            std::memcpy(&told.emplace_back(), message.data() + 1, sizeof(std::int64_t));
        }
        return told;
    }
    /// As long as a viewer is given to look at the beginning.
    void wait_for_history() {
        broadcast_.catch_up(now_);
        now_ += Broadcast::rewound_for;
        broadcast_.catch_up(now_);
    }

    RecordingLinks links_;
    Broadcast broadcast_{links_, "session"};
    Broadcast::Clock::time_point now_{};
};

TEST_F(BroadcastTest, GreetsWithServerInfoAndChannels) {
    publish("/map", 1);
    publish("/path", 2);
    broadcast_.opened(5);
    ASSERT_EQ(links_.texts[5].size(), 2U);
    EXPECT_EQ(links_.texts[5][0].at("op"), "serverInfo");
    EXPECT_EQ(links_.texts[5][0].at("sessionId"), "session");
    EXPECT_EQ(links_.texts[5][1].at("op"), "advertise");
    EXPECT_EQ(links_.texts[5][1].at("channels").size(), 2U);
    EXPECT_EQ(links_.times[5], std::vector{foxglove_time_message(2)});
    EXPECT_THAT(links_.data[5], IsEmpty());
}

TEST_F(BroadcastTest, AdvertisesANewTopicOnceToThoseWhoAreThere) {
    broadcast_.opened(0);
    EXPECT_EQ(links_.texts[0].back().at("channels").size(), 0U);
    publish("/map", 1);
    publish("/map", 2);
    ASSERT_EQ(links_.texts[0].size(), 3U);
    EXPECT_EQ(links_.texts[0].back().at("channels").at(0).at("topic"), "/map");
}

TEST_F(BroadcastTest, ASubscriberGetsTheLatestAtOnceAndAllThatFollow) {
    broadcast_.opened(0);
    broadcast_.opened(1);
    publish("/map", 1);
    publish("/map", 2);
    subscribe(0, 77, 0);
    EXPECT_THAT(stamps(0, 77), ElementsAre(2));
    publish("/map", 3);
    publish("/path", 4);
    EXPECT_THAT(stamps(0, 77), ElementsAre(2, 3));
    EXPECT_EQ(links_.data[0].size(), 2U) << "nothing of other topics";
    EXPECT_THAT(links_.data[1], IsEmpty()) << "nothing to who did not ask";
}

TEST_F(BroadcastTest, EndsASubscriptionAndLetsItStartAnew) {
    broadcast_.opened(0);
    publish("/map", 1);
    subscribe(0, 7, 0);
    unsubscribe(0, 7);
    publish("/map", 2);
    EXPECT_THAT(stamps(0, 7), ElementsAre(1));
    subscribe(0, 7, 0);
    EXPECT_THAT(stamps(0, 7), ElementsAre(1, 2));
    broadcast_.closed(0);
    publish("/map", 3);
    EXPECT_THAT(stamps(0, 7), ElementsAre(1, 2));
}

TEST_F(BroadcastTest, AnswersNonsenseWithAnErrorAndGoesOn) {
    broadcast_.opened(0);
    publish("/map", 1);
    publish("/path", 1);
    subscribe(0, 7, 0);
    const std::size_t before = links_.texts[0].size();
    broadcast_.received(0, "{", true);
    broadcast_.received(0, "\1binary", false);
    subscribe(0, 8, 9);  // the channel does not exist
    subscribe(0, 7, 1);  // the id is in use
    subscribe(0, 8, 0);  // the channel is in use
    unsubscribe(0, 99);
    ASSERT_EQ(links_.texts[0].size(), before + 6);
    for (std::size_t i = before; i < links_.texts[0].size(); ++i) {
        EXPECT_EQ(links_.texts[0][i].at("op"), "status");
        EXPECT_EQ(links_.texts[0][i].at("level"), 2);
    }
    publish("/map", 2);
    EXPECT_THAT(stamps(0, 7), ElementsAre(1, 2));
}

TEST_F(BroadcastTest, KeepsLittleForWhoDoesNotRead) {
    links_.slow = {0};
    broadcast_.opened(0);
    constexpr std::size_t size = 100'000;
    for (int i = 0; i < 1000; ++i) {
        publish("/map", i, size);
        subscribe(0, 7, 0);  // each call but the first is answered by an error message
        broadcast_.received(0, "{", true);
    }
    EXPECT_LT(links_.unsent[0], Broadcast::backlog_bytes + 2 * size);
    EXPECT_LT(stamps(0, 7).size(), 20U);
}

TEST_F(BroadcastTest, WhoReadsOnGetsTheLatestOfEachTopicOnceLongestWaitFirst) {
    publish("/map", 0);
    publish("/path", 0);
    publish("/pose", 0);
    broadcast_.opened(0);
    for (const std::uint32_t channel : {0U, 1U, 2U}) {
        subscribe(0, channel, channel);
    }
    links_.unsent[0] = Broadcast::backlog_bytes;
    links_.data[0].clear();
    publish("/pose", 1);
    publish("/map", 2);
    publish("/pose", 3);
    broadcast_.catch_up(now_);
    EXPECT_THAT(links_.data[0], IsEmpty());
    links_.unsent[0] = 0;
    broadcast_.catch_up(now_);
    broadcast_.catch_up(now_);
    EXPECT_THAT(links_.data[0], ElementsAre(foxglove_data_message(2, 3, std::vector<std::byte>(4)),
                                            foxglove_data_message(0, 2, std::vector<std::byte>(4))));
}

TEST_F(BroadcastTest, WhoeverReadsAtHisPaceGetsAnOrderedPartWithTheLatest) {
    std::mt19937 random(1);
    links_.slow = {0, 1, 2, 3};
    publish("/map", -1);
    for (const ClientId client : links_.slow) {
        broadcast_.opened(client);
        subscribe(client, 7, 0);
    }
    for (int i = 0; i < 2000; ++i) {
        publish("/map", i, 50'000);
        for (const ClientId client : links_.slow) {
            links_.unsent[client] -= std::min<std::size_t>(links_.unsent[client], random() % (30'000 * (client + 1)));
        }
        broadcast_.catch_up(now_);
    }
    for (const ClientId client : links_.slow) {
        links_.unsent[client] = 0;
        broadcast_.catch_up(now_);
        const std::vector<std::int64_t> got = stamps(client, 7);
        EXPECT_TRUE(std::is_sorted(got.begin(), got.end(), std::less_equal<>())) << "each once, in order";
        EXPECT_EQ(got.back(), 1999);
    }
    EXPECT_LT(stamps(0, 7).size(), stamps(1, 7).size()) << "the faster reader has more";
    EXPECT_EQ(stamps(3, 7).size(), 2001U) << "who is fast enough misses nothing";
}

TEST_F(BroadcastTest, GivesTheDegreesHistoryToWhoComesLate) {
    publish("/map", 1);
    for (std::int64_t stamp_ns = 2; stamp_ns <= 40; ++stamp_ns) {
        publish("/degeneracy", stamp_ns);
    }
    publish("/map", 50);
    broadcast_.opened(5);
    subscribe(5, 70, 0);
    subscribe(5, 71, 1);
    EXPECT_EQ(times(5).front(), 2) << "the clock begins at the first";
    EXPECT_EQ(times(5).back(), 2);
    wait_for_history();
    std::vector<std::int64_t> all(39);
    std::iota(all.begin(), all.end(), 2);
    EXPECT_EQ(stamps(5, 71), all);
    EXPECT_THAT(stamps(5, 70), ElementsAre(50)) << "of a map only the latest";
    EXPECT_TRUE(std::ranges::is_sorted(times(5)));
    EXPECT_EQ(times(5).back(), 50);
    publish("/degeneracy", 60);
    EXPECT_EQ(stamps(5, 71).back(), 60);
    EXPECT_EQ(stamps(5, 71).size(), 40U);
}

TEST_F(BroadcastTest, SetsTheClockBackForWhoAsksForTheHistoryLater) {
    publish("/degeneracy", 1);
    publish("/map", 2);
    broadcast_.opened(5);
    subscribe(5, 70, 1);
    wait_for_history();
    EXPECT_THAT(times(5), ElementsAre(1, 2));
    EXPECT_THAT(stamps(5, 70), ElementsAre(2));
    subscribe(5, 71, 0);
    EXPECT_THAT(times(5), ElementsAre(1, 2, 1));
    wait_for_history();
    EXPECT_THAT(stamps(5, 71), ElementsAre(1));
    EXPECT_THAT(stamps(5, 70), ElementsAre(2, 2)) << "again, because the clock was set back";
    EXPECT_EQ(times(5).back(), 2);
}

TEST_F(BroadcastTest, LeavesTheClockAtTheBeginningOfAHistoryUntilItWasLookedAt) {
    publish("/map", 1);
    publish("/degeneracy", 2);
    broadcast_.opened(5);
    broadcast_.catch_up(now_);
    now_ += Broadcast::rewound_for * 3 / 4;
    subscribe(5, 70, 0);
    subscribe(5, 71, 1);  // the wait begins anew
    publish("/degeneracy", 3);
    publish("/map", 4);
    broadcast_.catch_up(now_);
    now_ += Broadcast::rewound_for * 3 / 4;
    broadcast_.catch_up(now_);
    EXPECT_THAT(times(5), Each(2));
    EXPECT_THAT(links_.data[5], IsEmpty());
    wait_for_history();
    EXPECT_EQ(times(5).back(), 4);
    EXPECT_THAT(stamps(5, 71), ElementsAre(2, 3)) << "with what came meanwhile, each once";
    EXPECT_THAT(stamps(5, 70), ElementsAre(4));
}

TEST_F(BroadcastTest, GoesOnWithoutAHistoryThatNobodyWants) {
    publish("/degeneracy", 1);
    publish("/map", 2);
    broadcast_.opened(5);
    subscribe(5, 70, 0);
    subscribe(5, 71, 1);
    unsubscribe(5, 70);
    wait_for_history();
    EXPECT_THAT(stamps(5, 70), IsEmpty());
    EXPECT_THAT(stamps(5, 71), ElementsAre(2));
    EXPECT_EQ(times(5).back(), 2);
}

TEST_F(BroadcastTest, GivesASlowClientNoHistory) {
    broadcast_.opened(5);
    links_.slow.insert(5);
    publish("/map", 1, Broadcast::backlog_bytes);
    publish("/degeneracy", 2);
    publish("/degeneracy", 3);
    subscribe(5, 70, 0);
    subscribe(5, 71, 1);
    EXPECT_THAT(stamps(5, 71), IsEmpty());
    links_.unsent[5] = 0;
    broadcast_.catch_up(now_);
    EXPECT_THAT(stamps(5, 71), ElementsAre(3));
}

TEST(MessageHistory, KeepsALongRunFromItsStartToItsEndInBoundedMemory) {
    MessageHistory history;
    constexpr std::int64_t messages = 100'001;
    for (std::int64_t stamp_ns = 0; stamp_ns < messages; ++stamp_ns) {
        history.add(std::make_shared<const LiveMessage>(LiveMessage{"/degeneracy", "", stamp_ns, {}}));
    }
    const auto kept = history.messages();
    EXPECT_LE(kept.size(), MessageHistory::most_kept + 1);
    EXPECT_GE(kept.size(), MessageHistory::most_kept / 2);
    EXPECT_EQ(kept.front()->stamp_ns, 0);
    EXPECT_EQ(kept.back()->stamp_ns, messages - 1);
    for (std::size_t place = 2; place + 1 < kept.size(); ++place) {
        EXPECT_EQ(kept[place]->stamp_ns - kept[place - 1]->stamp_ns, kept[1]->stamp_ns);
    }
}

}  // namespace
}  // namespace ddtool

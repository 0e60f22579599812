#pragma once

#include <atomic>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "logs/containers/mcap_types.hpp"

namespace ddtool {

/// The messages of a robot on their way from the threads of DDS to that of the filter. They come in the order in which
/// they arrived, but of the scans of a topic that wait only the newest is kept: where scans come faster than they are
/// worked off, the filter gets the newest, and the others are counted as passed over. Poses, which are small, are all
/// kept up to most_waiting.
///
/// Topics are added by one thread; push() may be called by any, next() by one.
class RobotMessages {
public:
    static constexpr std::size_t most_waiting = 50'000;

    enum class Kind { scan, other };

    /// A message as it waits. Times are nanoseconds of the steady clock and of the clock that recordings use.
    struct Arrived {
        std::size_t channel = 0;
        std::vector<std::byte> data;
        std::int64_t arrived_ns = 0;
        std::int64_t log_time_ns = 0;
        std::uint64_t number = 0;  ///< of all messages, from 1 on
    };

    /// What is done with a message before it is given out; it may change its data.
    using Prepare = std::function<void(const McapChannel&, Arrived&)>;

    explicit RobotMessages(Prepare prepare) : prepare_(std::move(prepare)) {}

    /// Returns the number of the channel.
    std::size_t add_topic(const std::string& topic, const std::string& type_name, Kind kind);
    void push(std::size_t channel, std::span<const std::byte> data, std::int64_t arrived_ns, std::int64_t log_time_ns);

    /// Waits for a message; nullopt after `stop`, which is asked ten times a second, has returned true.
    std::optional<McapMessage> next(const std::function<bool()>& stop);

    /// Scans that were never given out because a newer one came first.
    [[nodiscard]] std::size_t passed_over() const { return passed_over_; }
    /// Scans that arrived.
    [[nodiscard]] std::size_t scans() const { return scans_; }

private:
    struct Topic {
        McapChannel channel;
        Kind kind = Kind::other;
    };

    Prepare prepare_;
    mutable std::mutex mutex_;
    std::deque<Topic> topics_;  ///< guarded by the mutex; a deque, so that channels stay in their places
    std::condition_variable arrived_;
    std::deque<Arrived> waiting_;  ///< guarded by the mutex
    std::uint64_t count_ = 0;      ///< guarded by the mutex
    std::atomic<std::size_t> passed_over_ = 0;
    std::atomic<std::size_t> scans_ = 0;
    Arrived given_;  ///< the message given out last
};

}  // namespace ddtool

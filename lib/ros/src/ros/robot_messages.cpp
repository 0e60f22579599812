#include "ros/robot_messages.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace ddtool {
namespace {

constexpr std::chrono::milliseconds between_questions{100};

}  // namespace

std::size_t RobotMessages::add_topic(const std::string& topic, const std::string& type_name, Kind kind) {
    const std::lock_guard lock(mutex_);
    const auto id = static_cast<std::uint16_t>(topics_.size() + 1);
    topics_.push_back({{.id = id,
                        .topic = topic,
                        .message_encoding = "cdr",
                        .metadata = {},
                        .schema = {.id = id, .name = type_name, .encoding = "ros2msg", .data = {}}},
                       kind});
    return topics_.size() - 1;
}

void RobotMessages::push(std::size_t channel, std::span<const std::byte> data, std::int64_t arrived_ns,
                         std::int64_t log_time_ns) {
    Arrived message{channel, {data.begin(), data.end()}, arrived_ns, log_time_ns, 0};
    {
        const std::lock_guard lock(mutex_);
        message.number = ++count_;
        if (topics_[channel].kind == Kind::scan) {
            ++scans_;
            passed_over_ += std::erase_if(waiting_, [&](const Arrived& each) { return each.channel == channel; });
        } else if (waiting_.size() >= most_waiting) {
            waiting_.pop_front();
        }
        waiting_.push_back(std::move(message));
    }
    arrived_.notify_one();
}

std::optional<McapMessage> RobotMessages::next(const std::function<bool()>& stop) {
    std::unique_lock lock(mutex_);
    do {
        if (stop()) {
            return std::nullopt;
        }
    } while (!arrived_.wait_for(lock, between_questions, [&] { return !waiting_.empty(); }));
    given_ = std::move(waiting_.front());
    waiting_.pop_front();
    const McapChannel& channel = topics_[given_.channel].channel;
    lock.unlock();
    prepare_(channel, given_);
    McapMessage message;
    message.channel = &channel;
    message.sequence = static_cast<std::uint32_t>(given_.number);
    message.log_time_ns = given_.log_time_ns;
    message.publish_time_ns = given_.log_time_ns;
    message.data = given_.data;
    message.file_offset = given_.number;
    message.offset_unit = "message";
    return message;
}

}  // namespace ddtool

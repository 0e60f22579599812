#include "logs/stream/live_log.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <thread>

#include "read_log.hpp"
#include "recording.hpp"
#include "system/atomic_file.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Followed : public testing::Test {
protected:
    Followed() {
        test::write_mcap(folder_ / "whole", test::example_recording());
        whole_ = read_file(folder_ / "whole");
        frames_ = test::read_all(folder_ / "whole").frames;
    }
    void append(std::string_view bytes) {
        std::ofstream(folder_ / "log", std::ios::binary | std::ios::app).write(bytes.data(), std::ssize(bytes));
    }
    test::ReadLog follow(const std::function<bool()>& stop) {
        return test::read_all(
            [&](const LogProblemHandler& on_problem) { return follow_log(folder_ / "log", {}, stop, on_problem); });
    }

    test::TemporaryFolder folder_;
    std::string whole_;
    std::vector<SensorFrame> frames_;
};

bool never() { return false; }

/// The recorder may write any number of bytes at a time, at any speed.
TEST_F(Followed, AFileThatGrowsGivesTheFramesOfTheWhole) {
    append("");
    std::thread recorder([this] {
        for (std::size_t at = 0; at < whole_.size(); at += 97) {
            append(std::string_view(whole_).substr(at, 97));
        }
    });
    const test::ReadLog log = follow(never);
    recorder.join();
    EXPECT_EQ(log.frames.size(), 9U);
    EXPECT_TRUE(test::begins_with(frames_, log.frames));
    EXPECT_THAT(log.problems, IsEmpty());
    EXPECT_EQ(log.error, "");
}

TEST_F(Followed, StopsOnRequestWithWhatIsThere) {
    append(std::string_view(whole_).substr(0, whole_.size() - 30));
    int waits = 0;
    const test::ReadLog log = follow([&] { return ++waits > 3; });
    EXPECT_EQ(log.frames.size(), 9U);
    EXPECT_THAT(log.problems, testing::Not(IsEmpty()));
}

TEST_F(Followed, WhatFollowsTheEndIsNotWaitedFor) {
    append(whole_ + "more");
    const test::ReadLog log = follow(never);
    EXPECT_EQ(log.frames.size(), 9U);
    EXPECT_THAT(log.problems, ElementsAre(HasSubstr("4 bytes follow the end")));
}

TEST_F(Followed, OnlyMcapIsFollowed) {
    append("#ROSBAG V2.0\n");
    EXPECT_THAT(follow(never).error, HasSubstr("starts like a ROS 1 bag"));
    std::filesystem::remove(folder_ / "log");
    EXPECT_THAT(follow(never).error, HasSubstr("cannot read: No such file"));
    std::filesystem::create_directory(folder_ / "log");
    EXPECT_THAT(follow(never).error, HasSubstr("is a folder; expected the MCAP file"));
}

}  // namespace
}  // namespace ddtool

#include "ros/stamp_watch.hpp"

#include <gmock/gmock.h>

namespace ddtool {
namespace {

constexpr std::int64_t ms = 1'000'000;
constexpr std::int64_t second = 1000 * ms;

/// A source that stamps a message every 100 ms, which arrives 5 ms later.
class Stamped {
public:
    explicit Stamped(StampWatch& watch, std::string name) : watch_(watch), name_(std::move(name)) {}

    /// The stamp as the filter gets it.
    std::int64_t at(std::int64_t time_ns, std::int64_t clock_off_ns = 0, std::int64_t delay_ns = 5 * ms) {
        const std::int64_t stamp_ns = time_ns + clock_off_ns;
        return stamp_ns + watch_.offset_ns(name_, stamp_ns, time_ns + delay_ns);
    }

private:
    StampWatch& watch_;
    std::string name_;
};

TEST(StampWatch, LeavesStampsOfASteadyClockAsTheyAre) {
    StampWatch watch(false);
    Stamped scan(watch, "scan");
    for (int step = 0; step < 1000; ++step) {
        const std::int64_t time_ns = 1000 * second + step * 100 * ms;
        EXPECT_EQ(scan.at(time_ns, 0, 5 * ms + step % 7 * 40 * ms), time_ns);
        EXPECT_FALSE(watch.new_jump());
    }
}

TEST(StampWatch, TakesADelayedMessageForNoJump) {
    StampWatch watch(false);
    Stamped scan(watch, "scan");
    scan.at(1000 * second);
    EXPECT_EQ(scan.at(1001 * second, 0, 5 * second), 1001 * second);
    EXPECT_EQ(scan.at(1005 * second, 0, 1005 * ms), 1005 * second);
    EXPECT_EQ(scan.at(1006 * second), 1006 * second);
    EXPECT_FALSE(watch.new_jump());
}

TEST(StampWatch, TakesALongSilenceForNoJump) {
    StampWatch watch(false);
    Stamped scan(watch, "scan");
    scan.at(1000 * second);
    EXPECT_EQ(scan.at(4600 * second), 4600 * second);
    EXPECT_FALSE(watch.new_jump());
}

class StampWatchJump : public testing::TestWithParam<std::int64_t> {};

TEST_P(StampWatchJump, GoesOnAsIfTheClockHadNotJumped) {
    StampWatch watch(false);
    Stamped scan(watch, "scan");
    Stamped odom(watch, "odom");
    for (int step = 0; step < 10; ++step) {
        scan.at(1000 * second + step * 100 * ms);
        odom.at(1000 * second + step * 100 * ms + 20 * ms);
    }
    const std::int64_t off_ns = GetParam() * second;
    const std::int64_t scan_ns = scan.at(1001 * second, off_ns, 9 * ms);
    ASSERT_TRUE(watch.new_jump());
    EXPECT_EQ(watch.new_jump()->source, "scan");
    EXPECT_NEAR(watch.new_jump()->by_s, static_cast<double>(GetParam()), 0.1);
    EXPECT_NEAR(static_cast<double>(scan_ns - 1001 * second), 0.0, 10.0 * ms);
    // The other source, whose clock is the same, stays exactly as far from it as it was, and is no second jump.
    EXPECT_EQ(odom.at(1001 * second + 20 * ms, off_ns) - scan_ns, 20 * ms);
    EXPECT_FALSE(watch.new_jump());
    EXPECT_EQ(scan.at(1001 * second + 100 * ms, off_ns) - scan_ns, 100 * ms);
    EXPECT_FALSE(watch.new_jump());
    EXPECT_EQ(watch.offset_of("scan"), watch.offset_of("odom"));
}

INSTANTIATE_TEST_SUITE_P(By, StampWatchJump, testing::Values(-1'000'000, -100, -2, 2, 3600));

TEST(StampWatch, KnowsTheOldClockAgainIfItComesBack) {
    StampWatch watch(false);
    Stamped scan(watch, "scan");
    scan.at(1000 * second);
    scan.at(1001 * second, -100 * second);
    EXPECT_TRUE(watch.new_jump());
    EXPECT_EQ(scan.at(1002 * second), 1002 * second);
    EXPECT_FALSE(watch.new_jump());
}

TEST(StampWatch, FollowsASimulatorThatRunsFasterAndStartsAgain) {
    StampWatch watch(true);
    const auto at = [&](std::int64_t stamp_ns, std::int64_t arrived_ns) {
        return stamp_ns + watch.offset_ns("scan", stamp_ns, arrived_ns);
    };
    EXPECT_EQ(at(10 * second, 1 * second), 10 * second);
    EXPECT_EQ(at(20 * second, 2 * second), 20 * second);
    EXPECT_EQ(at(20 * second + 100 * ms, 60 * second), 20 * second + 100 * ms);
    EXPECT_FALSE(watch.new_jump());
    const std::int64_t again_ns = at(0, 61 * second);
    EXPECT_TRUE(watch.new_jump());
    EXPECT_EQ(again_ns, 20 * second + 200 * ms);
    EXPECT_EQ(at(100 * ms, 62 * second) - again_ns, 100 * ms);
}

}  // namespace
}  // namespace ddtool

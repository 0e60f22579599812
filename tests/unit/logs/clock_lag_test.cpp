#include "logs/stream/clock_lag.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool {
namespace {

std::int64_t ns(double seconds) { return std::llround(1e9 * seconds); }

/// A topic at 20 Hz whose clock is ahead of the recorder's; the offset may grow with time.
ClockLag topic(double ahead_s, double per_s = 0.0, double from_s = 1000.0, int messages = 500) {
    ClockLag lag;
    for (int i = 0; i < messages; ++i) {
        const double recorded_s = from_s + 0.05 * i;
        lag.add(ns(recorded_s + ahead_s + per_s * 0.05 * i - 0.01 * (i % 3)), ns(recorded_s));
    }
    return lag;
}

TEST(ClockLag, TheDifferenceOfTwoClocksIsFound) {
    for (const double ahead_s : {4.3, -97200.0, 0.3}) {
        EXPECT_NEAR(ClockLag::offset_s(topic(0.0), topic(ahead_s)).value(), ahead_s, 0.03);
        EXPECT_NEAR(ClockLag::offset_s(topic(ahead_s), topic(0.0)).value(), -ahead_s, 0.03);
    }
}

TEST(ClockLag, BothClocksMayBeOtherThanTheRecorders) {
    EXPECT_NEAR(ClockLag::offset_s(topic(-1e8, -0.5), topic(-1e8 + 2.0, -0.5)).value(), 2.0, 0.05);
}

TEST(ClockLag, ADifferenceThatGrowsIsNone) {
    EXPECT_FALSE(ClockLag::offset_s(topic(0.0), topic(4.3, 0.1)));
    EXPECT_FALSE(ClockLag::offset_s(ClockLag(), topic(4.3)));
    EXPECT_FALSE(ClockLag::offset_s(topic(0.0), topic(4.3, 0.0, 1000.0, 5)));
}

TEST(ClockLag, ALongLogIsSampled) {
    EXPECT_NEAR(ClockLag::offset_s(topic(0.0, 0.0, 0.0, 50000), topic(4.3, 0.0, 0.0, 20000)).value(), 4.3, 0.03);
}

TEST(ClockLag, TellsWhetherTwoTopicsShareAMoment) {
    EXPECT_TRUE(ClockLag::overlap(topic(0.0), topic(5.0), 0.0));
    EXPECT_FALSE(ClockLag::overlap(topic(0.0), topic(50.0), 0.0));
    EXPECT_FALSE(ClockLag::overlap(topic(50.0), topic(0.0), 0.0));
    EXPECT_TRUE(ClockLag::overlap(topic(0.0), topic(50.0), 50.0));
    EXPECT_FALSE(ClockLag::overlap(ClockLag(), topic(0.0), 0.0));
}

TEST(ClockLag, StampsOfADamagedLogDoNoHarm) {
    ClockLag lag;
    for (int i = 0; i < 20; ++i) {
        lag.add(i % 2 == 0 ? INT64_MAX : INT64_MIN, i % 3 == 0 ? INT64_MIN : INT64_MAX);
    }
    EXPECT_FALSE(ClockLag::offset_s(lag, topic(0.0)));
}

}  // namespace
}  // namespace ddtool

#include "logs/stream/sweep_timer.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "logs/stream/message_log_stream.hpp"
#include "message_log.hpp"
#include "swept_scans.hpp"

namespace ddtool {
namespace {

using test::SweptScans;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

/// Of scans of 360 beams over a full turn.
SweepTiming timing_of(double period_s, double time_increment_s, std::size_t beams = 360) {
    ScanRate rate;
    for (int i = 0; i < 20; ++i) {
        LaserScan scan;
        scan.stamp_ns = std::llround(1e9 * period_s * i);
        scan.angle_increment_rad = 2.0 * M_PI / 360.0;
        scan.time_increment_s = time_increment_s;
        scan.ranges_m.assign(beams, 1.0F);
        rate.add(scan, i % 2 == 0 ? "front" : "rear");
    }
    return find_sweep_timing(rate);
}

testing::Matcher<double> about(double seconds) { return DoubleNear(seconds, 1e-9); }

TEST(SweepTiming, IsWhatTheScansState) {
    // two lidars on one topic: each has every second scan
    const SweepTiming timing = timing_of(0.05, 0.1 / 360.0);
    EXPECT_THAT(timing.turns_s, ElementsAre(about(0.1), about(0.0), about(-0.1)));
    EXPECT_EQ(timing.doubt, "");
}

TEST(SweepTiming, IsDoubtedWhereTheBeamsDoNotFitBetweenTwoScans) {
    for (const double stated_s : {0.01, -1e-4}) {
        const SweepTiming timing = timing_of(0.05, stated_s);
        EXPECT_THAT(timing.turns_s, ElementsAre(about(0.1), about(0.0), about(-0.1)));
        EXPECT_THAT(timing.doubt, HasSubstr("cannot be"));
    }
    EXPECT_EQ(timing_of(0.05, NAN).doubt, "");
}

TEST(SweepTiming, MayBeOneTurnAScanWhereNothingIsStated) {
    EXPECT_THAT(timing_of(0.05, 0.0).turns_s, ElementsAre(about(0.0), about(0.1), about(-0.1)));
    // thinned out
    EXPECT_THAT(timing_of(1.0, 0.0).turns_s, ElementsAre(0.0));
}

TEST(SweepTiming, OfAPartOfATurnTakesThatPartOfTheTime) {
    const SweepTiming timing = timing_of(0.05, 0.0, 181);
    SweepTimer timer(timing);
    SensorFrame frame;
    frame.scan.angle_increment_rad = 2.0 * M_PI / 360.0;
    frame.scan.ranges_m.assign(181, 1.0F);
    EXPECT_NEAR(timer.longest_s(frame.scan), 0.05, 1e-9);
}

/// The frames that a log of swept scans gives, with the assumptions of the stream.
struct Read {
    std::vector<SensorFrame> frames;
    std::vector<std::string> assumptions;
};

Read read_swept(int order, float time_increment_s,
                MessageLogStream::Opening opening = MessageLogStream::Opening::twice) {
    test::MessageLog log;
    int odometry = 0;
    const auto add_odometry = [&](double until_s) {
        for (; 0.02 * odometry <= until_s; ++odometry) {
            const std::int64_t stamp_ns = std::int64_t{20'000'000} * odometry;
            log.add("/odom", stamp_ns,
                    odometry_message(stamp_ns, "odom", "base", SweptScans::robot_at(0.02 * odometry)));
        }
    };
    log.add("/tf_static", 0, transform_message(0, "base", "laser", {0.2, 0.0, 0.0}));
    for (int i = 1; i <= 50; ++i) {
        const double t_s = SweptScans::scan_every_s * i;
        add_odometry(t_s);
        const SensorFrame frame = SweptScans{.order = order}.scan_at(t_s);
        RosLaserScan message = scan_message(frame.scan, "laser");
        message.time_increment = time_increment_s;
        log.add("/scan", frame.scan.stamp_ns, message);
    }
    add_odometry(11.0);
    MessageLogStream stream([&](const LogProblemHandler&) { return log.open(); }, opening, "test", "log", {},
                            [](const LogProblem&) {});
    Read read;
    while (auto frame = stream.next()) {
        read.frames.push_back(std::move(*frame));
    }
    read.assumptions = stream.summary().assumptions;
    return read;
}

TEST(SweepTimer, TakesTheStatedTimesOfALog) {
    const Read read = read_swept(1, static_cast<float>(SweptScans::turn_s / SweptScans::beams));
    EXPECT_TRUE(read.assumptions.empty());
    ASSERT_EQ(read.frames.size(), 50U);
    for (const SensorFrame& frame : read.frames) {
        ASSERT_FALSE(frame.sweep.empty());
        const double last_s = 1e-9 * static_cast<double>(frame.scan.stamp_ns) +
                              SweptScans::turn_s * (SweptScans::beams - 1) / SweptScans::beams;
        const Pose2 expected = between(frame.odom_from_robot, SweptScans::robot_at(last_s));
        EXPECT_LT(distance_m(frame.sweep.back(), expected), 1e-3);
        EXPECT_NEAR(frame.sweep.back().theta_rad, expected.theta_rad, 1e-3);
    }
}

TEST(SweepTimer, FindsTimesThatAreMissingOrWrong) {
    for (const auto& [order, text] : {std::pair(1, "one after the other, a turn in 200.0 ms, not all at once"),
                                      std::pair(-1, "from the last to the first")}) {
        const Read read = read_swept(order, 0.0F);
        EXPECT_FALSE(read.frames.front().sweep.empty());
        EXPECT_NEAR(read.frames.back().scan.time_increment_s, SweptScans::turn_s / SweptScans::beams, 1e-6);
        EXPECT_EQ(read.frames.back().scan.angle_increment_rad > 0.0, order > 0);
        EXPECT_THAT(read.assumptions, ElementsAre(HasSubstr(text)));
    }
    const Read read = read_swept(0, static_cast<float>(SweptScans::turn_s / SweptScans::beams));
    EXPECT_TRUE(read.frames.front().sweep.empty());
    EXPECT_THAT(read.assumptions, ElementsAre(HasSubstr("measured all at once, not one after the other")));
}

TEST(SweepTimer, FindsTimesOnTheWayInALogThatIsReadOnce) {
    const Read read = read_swept(1, 0.0F, MessageLogStream::Opening::once);
    EXPECT_TRUE(read.frames.front().sweep.empty());
    EXPECT_FALSE(read.frames.back().sweep.empty());
    EXPECT_THAT(read.assumptions, ElementsAre(HasSubstr("one after the other")));
}

TEST(SweepTimer, BelievesScansThatAreMeasuredAllAtOnce) {
    const Read read = read_swept(0, 0.0F);
    EXPECT_TRUE(read.assumptions.empty());
    for (const SensorFrame& frame : read.frames) {
        EXPECT_TRUE(frame.sweep.empty());
        EXPECT_EQ(frame.scan.time_increment_s, 0.0);
    }
}

}  // namespace
}  // namespace ddtool

#include "logs/stream/stamp_survey.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <functional>

#include "ddtool/base/random.hpp"
#include "read_log.hpp"
#include "recording.hpp"
#include "temporary_folder.hpp"

namespace ddtool {
namespace {

using testing::HasSubstr;

constexpr std::int64_t s = 1'000'000'000;
constexpr std::int64_t wall_ns = 1'700'000'000 * s + 123'456'789;

/// A time as a function of the true time, both in nanoseconds.
using Clock = std::function<std::int64_t(std::int64_t)>;

std::int64_t truth(std::int64_t time_ns) { return time_ns; }

/// The times at which the messages arrive: up to 8 ms late.
Clock recorder() {
    return [random = std::make_shared<RandomStream>(RandomStream{7})](std::int64_t time_ns) {
        return wall_ns + time_ns + static_cast<std::int64_t>(random->index(8'000'000));
    };
}

struct Heard {
    StampRule rule;
    std::vector<std::int64_t> times_ns;  ///< by the rule
};

/// What is made of messages at a rate for some time, the stamps of which are told by a clock.
Heard hear(double rate_hz, double duration_s, const Clock& stamp, const Clock& recorded) {
    std::vector<std::pair<std::int64_t, std::int64_t>> messages;
    for (std::int64_t i = 0; static_cast<double>(i) < rate_hz * duration_s; ++i) {
        const auto time_ns = std::llround(1e9 * static_cast<double>(i) / rate_hz);
        messages.emplace_back(stamp(time_ns), recorded(time_ns));
    }
    StampSurvey survey;
    for (const auto& [stamp_ns, recorded_ns] : messages) {
        survey.add(stamp_ns == 0 ? recorded_ns : stamp_ns, stamp_ns != 0, recorded_ns);
    }
    Heard heard{survey.rule("the scans /scan"), {}};
    StampReader reader(heard.rule);
    for (const auto& [stamp_ns, recorded_ns] : messages) {
        heard.times_ns.push_back(reader.time_ns(stamp_ns == 0 ? recorded_ns : stamp_ns, stamp_ns != 0, recorded_ns));
    }
    return heard;
}

double duration_s(const Heard& heard) {
    return 1e-9 * static_cast<double>(heard.times_ns.back() - heard.times_ns.front());
}

void expect_sound(const Heard& heard, const std::string& what) {
    EXPECT_EQ(heard.rule.assumption, "") << what;
    EXPECT_EQ(heard.rule.fault, "") << what;
    EXPECT_FALSE(heard.rule.from_recording) << what;
    EXPECT_EQ(heard.rule.period_ns, 0) << what;
}

Clock rounded_to(std::int64_t unit_ns, std::int64_t start_ns = wall_ns) {
    return [=](std::int64_t time_ns) { return (start_ns + time_ns) / unit_ns * unit_ns; };
}

Clock wrapped_at(std::int64_t period_ns, std::int64_t start_ns) {
    return [=](std::int64_t time_ns) { return (start_ns + time_ns) % period_ns; };
}

TEST(StampSurvey, SoundStampsAreLeftAlone) {
    const Clock recorded = recorder();
    expect_sound(hear(
                     5.0, 50.0, [](auto t) { return wall_ns + t; }, recorded),
                 "wall clock");
    expect_sound(hear(1.0, 50.0, rounded_to(1), recorded), "one a second");
    expect_sound(hear(
                     1.0, 50.0, [](auto t) { return 1'700'000'000 * s + t; }, recorded),
                 "one at each whole second");
    expect_sound(hear(
                     10.0, 50.0, [](auto t) { return 5 * s + t; }, recorded),
                 "simulated, on tenths of a second");
    expect_sound(hear(
                     10.0, 50.0, [](auto t) { return 5 * s + t; }, [](auto t) { return 5 * s + t; }),
                 "recorded so");
    expect_sound(hear(
                     10.0, 50.0, [](auto t) { return 5 * s + t; }, [&](auto t) { return recorded(3 * t); }),
                 "simulated three times slower");
    expect_sound(hear(
                     10.0, 50.0, [](auto t) { return (5 * s + t) % (40 * s); }, recorded),
                 "simulation started again");
    expect_sound(hear(
                     20.0, 50.0, [](auto t) { return 5 * s + t / (s / 10) * (s / 10); },
                     [&](auto t) { return recorded(t / (s / 10) * (s / 10)); }),
                 "two simulated lidars, stamped and recorded together");
}

TEST(StampSurvey, AFirstStampOfZeroIsOneWhereTheNextIsSmall) {
    const Heard heard = hear(5.0, 46.8, truth, recorder());
    expect_sound(heard, "simulated from 0");
    EXPECT_EQ(heard.times_ns.front(), 0);
    EXPECT_NEAR(duration_s(heard), 46.6, 1e-6);
}

TEST(StampSurvey, AMissingStampIsTheTimeOfRecordingOnTheClockOfTheOthers) {
    const auto lost = [](std::int64_t start_ns) {
        return [=](std::int64_t time_ns) { return time_ns == 4 * s || time_ns == 0 ? 0 : start_ns + time_ns; };
    };
    for (const std::int64_t start_ns : {wall_ns, 86'400 * s}) {
        const Heard heard = hear(5.0, 20.0, lost(start_ns), recorder());
        expect_sound(heard, std::to_string(start_ns));
        EXPECT_NEAR(1e-9 * static_cast<double>(heard.times_ns[20] - start_ns), 4.0, 0.02);
        EXPECT_NEAR(1e-9 * static_cast<double>(heard.times_ns[0] - start_ns), 0.0, 0.02);
    }
}

TEST(StampSurvey, WhereStampsSayNothingTheTimesOfRecordingDo) {
    const Clock recorded = recorder();
    const auto expect_recorded = [&](double rate_hz, const Clock& stamp, const std::string& what) {
        const Heard heard = hear(rate_hz, 60.0, stamp, recorded);
        EXPECT_THAT(heard.rule.assumption,
                    testing::AllOf(HasSubstr("the stamps of the scans /scan are " + what), HasSubstr("of recording")));
        EXPECT_NEAR(duration_s(heard), 60.0 - 1.0 / rate_hz, 0.02) << what;
    };
    expect_recorded(
        5.0, [](auto) { return 0; }, "all 0");
    expect_recorded(
        5.0, [](auto) { return wall_ns; }, "all equal");
    for (const double rate_hz : {2.0, 5.0, 12.5, 40.0}) {
        expect_recorded(rate_hz, rounded_to(s), "rounded to whole seconds");
        expect_recorded(rate_hz, rounded_to(s, 5 * s), "rounded to whole seconds");
    }
    expect_recorded(5.0, rounded_to(16 * s), "rounded to whole seconds");
    expect_recorded(40.0, rounded_to(s / 10), "rounded to 0.1 s");
    expect_recorded(5.0, wrapped_at(std::int64_t{1} << 32, 0), "wrapped: they start again at 0 after 4.3 s");
    expect_recorded(5.0, wrapped_at(1000 * (std::int64_t{1} << 32), 4270 * s),
                    "wrapped: they start again at 0 after 4295");
    expect_recorded(5.0, wrapped_at(1'000'000 * (std::int64_t{1} << 32), 4'294'950 * s), "wrapped");
}

TEST(StampSurvey, WithoutGoodTimesOfRecordingOnlyWrappedStampsCanBeMended) {
    const Clock wrapped = wrapped_at(std::int64_t{1} << 32, s);
    const Heard heard = hear(5.0, 60.0, wrapped, wrapped);
    EXPECT_THAT(heard.rule.assumption, HasSubstr("they are counted on"));
    EXPECT_NEAR(duration_s(heard), 59.8, 1e-6);
    const Heard rounded = hear(5.0, 60.0, rounded_to(s), rounded_to(s));
    EXPECT_THAT(rounded.rule.fault, HasSubstr("rounded to whole seconds, and their times of recording are no better"));
    const Heard still = hear(
        5.0, 60.0, [](auto) { return wall_ns; }, [](auto) { return wall_ns; });
    EXPECT_THAT(still.rule.fault, HasSubstr("all equal, and their times"));
}

/// A recording of scans and odometry, each stamped by its own clock.
test::Recording stamped(const Clock& scan_stamp, const Clock& odom_stamp) {
    test::Recording recording;
    const Clock recorded = recorder();
    for (std::int64_t time_ns = 0; time_ns < 20 * s; time_ns += s / 50) {
        const double x_m = 0.5e-9 * static_cast<double>(time_ns);
        test::record(recording, "/odom", recorded(time_ns),
                     odometry_message(odom_stamp(time_ns), "odom", "base", {x_m, 0.0, 0.0}));
        if (time_ns % (s / 5) == 0) {
            RosLaserScan scan;
            scan.header = {{scan_stamp(time_ns)}, "laser"};
            scan.angle_min = -1.0F;
            scan.angle_increment = 0.5F;
            scan.range_max = 10.0F;
            scan.ranges = {1.0F, 2.0F, 3.0F, static_cast<float>(10.0 - 0.5 * x_m)};
            test::record(recording, "/scan", recorded(time_ns), scan);
        }
    }
    return recording;
}

/// Whatever is wrong with the stamps: the frames last 19.8 s, and each has the odometry of its moment.
TEST(StampSurvey, FramesHaveTheirTimesAndOdometry) {
    const Clock wall = [](auto t) { return wall_ns + t; };
    const Clock nanoseconds = wrapped_at(std::int64_t{1} << 32, 0);
    const std::vector<std::pair<Clock, Clock>> clocks{
        {truth, truth},        {rounded_to(s), wall},          {rounded_to(s), rounded_to(s)},
        {wall, rounded_to(s)}, {nanoseconds, nanoseconds},     {nanoseconds, wall},
        {wall, nanoseconds},   {[](auto) { return s; }, wall}, {[](auto) { return 0; }, [](auto) { return 0; }}};
    for (std::size_t i = 0; i < clocks.size(); ++i) {
        const test::TemporaryFolder folder;
        test::write_mcap(folder / "log", stamped(clocks[i].first, clocks[i].second));
        const test::ReadLog log = test::read_all(folder / "log");
        EXPECT_EQ(log.error, "") << i;
        EXPECT_THAT(log.problems, testing::IsEmpty()) << i;
        ASSERT_EQ(log.frames.size(), 100U) << i;
        EXPECT_NEAR(1e-9 * static_cast<double>(log.frames.back().scan.stamp_ns - log.frames.front().scan.stamp_ns),
                    19.8, 0.02)
            << i;
        for (std::size_t frame = 1; frame + 1 < 100; ++frame) {
            EXPECT_NEAR(log.frames[frame].odom_from_robot.x_m, 0.1 * static_cast<double>(frame), 0.012) << i;
        }
    }
}

}  // namespace
}  // namespace ddtool

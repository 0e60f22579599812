#include "logs/stream/idle_options.hpp"

#include <gmock/gmock.h>

namespace ddtool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(IdleOptions, AreNamedWithTheReason) {
    LogOptions options;
    EXPECT_THAT(options_without_effect(options, {}), IsEmpty());
    options.height = HeightBand{0.1, 1.0};
    options.cloud_beams = 360;
    options.strongest_echo = true;
    options.odom_path = 2;
    options.odom_delay_s = 0.1;
    options.imu_topic = "/imu";
    EXPECT_THAT(options_without_effect(options, {}),
                ElementsAre(HasSubstr("--height has no effect: no point clouds are used"), HasSubstr("log.cloud_beams"),
                            HasSubstr("log.echo"), HasSubstr("--odom-path has no effect: no odometry is used"),
                            HasSubstr("--odom-delay"), HasSubstr("--imu-topic")));
    EXPECT_THAT(options_without_effect(options, {.clouds = true, .echoes = true, .odometry = true}), IsEmpty());
    options = {};
    options.imu_topic = "none";
    EXPECT_THAT(options_without_effect(options, {}), IsEmpty());
}

}  // namespace
}  // namespace ddtool

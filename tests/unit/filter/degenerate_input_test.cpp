#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>

#include "ddtool/methods/method.hpp"
#include "room_run.hpp"
#include "thrown_text.hpp"

namespace ddtool {
namespace {

std::vector<SensorFrame> jumping_by(double distance_m) {
    std::vector<SensorFrame> frames = room_drive();
    for (std::size_t i = frames.size() / 2; i < frames.size(); ++i) {
        frames[i].odom_from_robot = Pose2{distance_m, 0.0, 0.0} * frames[i].odom_from_robot;
    }
    return frames;
}

TEST(DegenerateInput, ALongJumpIsFollowedAndAnImpossibleOneNamed) {
    for (const double distance_m : {100.0, 1e4}) {
        const std::vector<SensorFrame> frames = jumping_by(distance_m);
        expect_finite_pose_for_every_scan(filtered(frames, few_particles(), {}, 2), frames);
    }
    for (const double distance_m : {1e8, 1e12}) {
        EXPECT_THAT(test::thrown_text([&] { filtered(jumping_by(distance_m), few_particles(), {}, 2); }),
                    testing::HasSubstr("the poses jump"))
            << distance_m;
    }
}

TEST(DegenerateInput, ALidarMountedBackwardsSeesTheSame) {
    std::vector<SensorFrame> frames = room_drive();
    for (SensorFrame& frame : frames) {
        frame.robot_from_laser = frame.robot_from_laser * Pose2{0.0, 0.0, std::numbers::pi};
        frame.scan.angle_min_rad -= std::numbers::pi;
    }
    const Trajectory turned = filtered(frames, few_particles());
    const Trajectory plain = filtered(room_drive(), few_particles());
    ASSERT_EQ(turned.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i) {
        EXPECT_LT(distance_m(turned[i].pose, plain[i].pose), 0.05) << i;
    }
}

TEST(DegenerateInput, AMillionBeamsAreAScan) {
    std::vector<SensorFrame> frames(room_drive().begin(), room_drive().begin() + 8);
    for (SensorFrame& frame : frames) {
        std::vector<float> ranges;
        const std::size_t times = 1'000'000 / frame.scan.ranges_m.size();
        for (const float range : frame.scan.ranges_m) {
            ranges.insert(ranges.end(), times, range);
        }
        frame.scan.angle_increment_rad /= static_cast<double>(times);
        frame.scan.ranges_m = std::move(ranges);
    }
    expect_finite_pose_for_every_scan(filtered(frames, few_particles(2)), frames);
}

class EveryMethod : public testing::TestWithParam<std::string> {};

/// The lidar sees nothing for a while and then everything again. The filter has a single particle.
TEST_P(EveryMethod, GoesOnAfterABlindStretch) {
    std::vector<SensorFrame> frames = room_drive();
    for (std::size_t i = frames.size() / 3; i < frames.size() / 2; ++i) {
        std::fill(frames[i].scan.ranges_m.begin(), frames[i].scan.ranges_m.end(), LaserScan::no_return);
    }
    FilterSettings settings;
    settings.method.method = GetParam();
    settings.rbpf.particles = 1;
    ThreadPool threads(1);
    const auto filter = make_filter(settings, DetectorTable(), threads);
    for (const SensorFrame& frame : frames) {
        filter->update(frame);
    }
    expect_finite_pose_for_every_scan(filter->trajectory(), frames);
    EXPECT_TRUE(filter->pose_covariance().allFinite());
}

INSTANTIATE_TEST_SUITE_P(Methods, EveryMethod, testing::ValuesIn(method_names()), [](const auto& info) {
    std::string name = info.param;
    std::erase(name, '-');
    return name;
});

}  // namespace
}  // namespace ddtool

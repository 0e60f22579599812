#include "ddtool/filter/scan_odometry.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "room_run.hpp"

namespace ddtool {
namespace {

class Frames : public SensorStream {
public:
    explicit Frames(std::vector<SensorFrame> frames) : frames_(std::move(frames)) {}
    std::optional<SensorFrame> next() override {
        return next_ < frames_.size() ? std::optional(frames_[next_++]) : std::nullopt;
    }
    [[nodiscard]] double fraction_read() const override { return 0.5; }

private:
    std::vector<SensorFrame> frames_;
    std::size_t next_ = 0;
};

std::vector<SensorFrame> without_odometry(std::vector<SensorFrame> frames) {
    for (SensorFrame& frame : frames) {
        frame.odom_from_robot = {};
        frame.odom_step = OdometryStep::unknown;
    }
    return frames;
}

std::vector<SensorFrame> completed(const std::vector<SensorFrame>& frames) {
    Frames source(frames);
    ScanOdometryStream stream(source, few_particles());
    std::vector<SensorFrame> result;
    while (std::optional<SensorFrame> frame = stream.next()) {
        result.push_back(*std::move(frame));
    }
    return result;
}

std::vector<SensorFrame> with_scan_odometry(const std::vector<SensorFrame>& frames) {
    return completed(without_odometry(frames));
}

/// The drive with true odometry, which is missing for the frames from a third to a half of it, and starts again then at
/// another pose.
std::vector<SensorFrame> with_a_hole(OdometryStep step) {
    std::vector<SensorFrame> frames = room_drive();
    const std::size_t from = frames.size() / 3;
    const std::size_t to = frames.size() / 2;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i].odom_from_robot = *frames[i].world_from_robot;
        if (i >= from && i < to) {
            frames[i].odom_from_robot = frames[from].odom_from_robot;
        }
        if (i >= to) {
            frames[i].odom_from_robot = Pose2{5.0, -3.0, 2.0} * frames[i].odom_from_robot;
        }
        if (i > from && i <= to) {
            frames[i].odom_step = step;
        }
    }
    return frames;
}

/// The largest distance between the estimated and the true motion since the first frame.
double largest_odometry_error_m(const std::vector<SensorFrame>& frames) {
    double largest = 0.0;
    for (const SensorFrame& frame : frames) {
        const Pose2 truth = between(*frames.front().world_from_robot, *frame.world_from_robot);
        largest = std::max(largest, distance_m(between(frames.front().odom_from_robot, frame.odom_from_robot), truth));
    }
    return largest;
}

TEST(ScanOdometry, FollowsTheRobotThroughARoom) {
    const std::vector<SensorFrame> frames = with_scan_odometry(room_drive());
    ASSERT_EQ(frames.size(), room_drive().size());
    EXPECT_LT(largest_odometry_error_m(frames), 0.1);
    EXPECT_GT(largest_odometry_error_m(without_odometry(room_drive())), 1.0);
}

TEST(ScanOdometry, FillsAHoleInTheOdometry) {
    EXPECT_GT(largest_odometry_error_m(with_a_hole(OdometryStep::unknown)), 1.0);
    EXPECT_LT(largest_odometry_error_m(completed(with_a_hole(OdometryStep::unknown))), 0.06);
}

TEST(ScanOdometry, LeavesMeasuredOdometryAsItIsToTheLastBit) {
    const std::vector<SensorFrame> frames = completed(room_drive());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].odom_from_robot, room_drive()[i].odom_from_robot);
    }
}

TEST(ScanOdometry, LeavesEverythingElseAsItIs) {
    const std::vector<SensorFrame> frames = with_scan_odometry(room_drive());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        EXPECT_EQ(frames[i].scan.stamp_ns, room_drive()[i].scan.stamp_ns);
        const std::vector<float>& ranges_m = room_drive()[i].scan.ranges_m;  // contains NaN values
        ASSERT_EQ(frames[i].scan.ranges_m.size(), ranges_m.size());
        EXPECT_EQ(std::memcmp(frames[i].scan.ranges_m.data(), ranges_m.data(), ranges_m.size() * sizeof(float)), 0);
        EXPECT_EQ(frames[i].robot_from_laser, room_drive()[i].robot_from_laser);
    }
}

TEST(ScanOdometry, StaysFiniteWithoutReturnsAndWithoutTime) {
    std::vector<SensorFrame> blind = room_drive();
    for (SensorFrame& frame : blind) {
        std::fill(frame.scan.ranges_m.begin(), frame.scan.ranges_m.end(), LaserScan::no_return);
        frame.scan.stamp_ns = 7;
    }
    for (const SensorFrame& frame : with_scan_odometry(blind)) {
        EXPECT_TRUE(std::isfinite(frame.odom_from_robot.x_m) && std::isfinite(frame.odom_from_robot.theta_rad));
    }
}

/// Frames to each of which the one before is joined.
std::vector<SensorFrame> joined_in_pairs(const std::vector<SensorFrame>& frames) {
    std::vector<SensorFrame> pairs;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        pairs.push_back(frames[i]);
        pairs.back().joined = {frames[i - 1]};
    }
    return pairs;
}

TEST(ScanOdometry, PlacesJoinedScansByTheSpeed) {
    const std::vector<SensorFrame> frames = with_scan_odometry(joined_in_pairs(room_drive()));
    EXPECT_LT(largest_odometry_error_m(frames), 0.1);
    double error_m = 0.0;
    double way_m = 0.0;
    for (const SensorFrame& frame : frames) {
        const SensorFrame& other = frame.joined.at(0);
        const Pose2 truth = between(*frame.world_from_robot, *other.world_from_robot);
        error_m += distance_m(between(frame.odom_from_robot, other.odom_from_robot), truth);
        way_m += distance_m({}, truth);
    }
    EXPECT_LT(error_m, 0.3 * way_m);
}

}  // namespace
}  // namespace ddtool

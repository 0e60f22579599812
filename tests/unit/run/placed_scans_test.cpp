#include "run/placed_scans.hpp"

#include <gmock/gmock.h>

#include <deque>

namespace ddtool {
namespace {

/// Frames of a robot that drives one metre between two frames, by its odometry from (5, 0) on.
class Drive : public SensorStream {
public:
    std::optional<SensorFrame> next() override {
        SensorFrame frame;
        frame.odom_from_robot = {5.0 + driven_m_, 0.0, 0.0};
        frame.joined.push_back(frame);
        driven_m_ += 1.0;
        return frame;
    }
    [[nodiscard]] double fraction_read() const override { return 0.0; }

private:
    double driven_m_ = 0.0;
};

/// A filter that believes a pose.
class Believer : public ParticleFilter {
public:
    std::optional<Update> update(const SensorFrame& /*frame*/) override { return std::nullopt; }
    [[nodiscard]] const OccupancyGrid& map() const override { return map_; }
    [[nodiscard]] Pose2 pose() const override { return believed; }
    [[nodiscard]] Eigen::Matrix3d pose_covariance() const override { return Eigen::Matrix3d::Zero(); }
    void visit_trajectory(const PoseVisitor& /*visit*/) const override {}

    Pose2 believed;

private:
    OccupancyGrid map_{OccupancySettings{}};
};

struct Told {
    std::optional<Pose2> pose;
    std::optional<Pose2> operator()() { return std::exchange(pose, std::nullopt); }
};

void expect_placed(const Pose2& found, const Pose2& expected) {
    EXPECT_NEAR(found.x_m, expected.x_m, 1e-9);
    EXPECT_NEAR(found.y_m, expected.y_m, 1e-9);
    EXPECT_NEAR(wrap_angle(found.theta_rad - expected.theta_rad), 0.0, 1e-9);
}

TEST(PlacedScans, LeaveTheOdometryAsItIsIfNothingIsTold) {
    Drive drive;
    const Believer filter;
    PlacedScans placed(drive, filter, [] { return std::optional<Pose2>(); });
    EXPECT_EQ(placed.next()->odom_from_robot, (Pose2{5.0, 0.0, 0.0}));
    EXPECT_EQ(placed.next()->odom_from_robot, (Pose2{6.0, 0.0, 0.0}));
}

TEST(PlacedScans, StartWhereTheRobotIsTold) {
    Drive drive;
    const Believer filter;
    Told told{Pose2{1.0, 2.0, 1.5707963267948966}};
    PlacedScans placed(drive, filter, [&] { return told(); });
    expect_placed(placed.next()->odom_from_robot, {1.0, 2.0, 1.5707963267948966});
    const auto second = placed.next();
    expect_placed(second->odom_from_robot, {1.0, 3.0, 1.5707963267948966});
    expect_placed(second->joined.front().odom_from_robot, {1.0, 3.0, 1.5707963267948966});
}

TEST(PlacedScans, MakeAStepFromWhereTheFilterIsToWhereTheRobotIsTold) {
    Drive drive;
    Believer filter;
    Told told;
    PlacedScans placed(drive, filter, [&] { return told(); });
    const Pose2 before = placed.next()->odom_from_robot;
    filter.believed = {20.0, 10.0, 3.0};
    told.pose = Pose2{-4.0, 7.0, -1.0};
    const Pose2 after = placed.next()->odom_from_robot;
    expect_placed(filter.believed * between(before, after), {-4.0, 7.0, -1.0});
    expect_placed(between(after, placed.next()->odom_from_robot), {1.0, 0.0, 0.0});
}

}  // namespace
}  // namespace ddtool

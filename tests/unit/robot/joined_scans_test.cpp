#include "ddtool/robot/joined_scans.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "ddtool/robot/scan_points.hpp"

namespace ddtool {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// A lidar with that number took a scan at a time.
struct Taken {
    std::size_t lidar = 0;
    double stamp_s = 0.0;
};

class TakenScans : public SensorStream {
public:
    explicit TakenScans(std::vector<Taken> scans) : scans_(std::move(scans)) {}
    std::optional<SensorFrame> next() override {
        if (next_ == scans_.size()) {
            return std::nullopt;
        }
        SensorFrame frame;
        frame.lidar = scans_[next_].lidar;
        frame.scan.stamp_ns = std::llround(1e9 * scans_[next_++].stamp_s);
        return frame;
    }
    [[nodiscard]] double fraction_read() const override { return 0.0; }

private:
    std::vector<Taken> scans_;
    std::size_t next_ = 0;
};

/// The stamps of each frame's scans in tenths of a second, the frame's own first.
std::vector<std::vector<long>> joined(std::vector<Taken> scans) {
    TakenScans source(std::move(scans));
    JoinedScans stream(source);
    std::vector<std::vector<long>> frames;
    while (const auto frame = stream.next()) {
        frames.push_back({std::lround(1e-8 * static_cast<double>(frame->scan.stamp_ns))});
        for (const SensorFrame& other : frame->joined) {
            frames.back().push_back(std::lround(1e-8 * static_cast<double>(other.scan.stamp_ns)));
        }
    }
    return frames;
}

TEST(JoinedScans, OfOneLidarAreItsFrames) {
    EXPECT_THAT(joined({{0, 1.0}, {0, 1.1}}), ElementsAre(ElementsAre(10), ElementsAre(11)));
}

TEST(JoinedScans, AddTheLatestOfTheOtherLidars) {
    EXPECT_THAT(joined({{1, 0.9}, {0, 1.0}, {1, 1.1}, {2, 1.1}, {2, 1.2}, {0, 1.2}, {0, 1.3}}),
                ElementsAre(ElementsAre(10, 9), ElementsAre(12, 11, 12), ElementsAre(13, 11, 12)));
}

TEST(JoinedScans, LeaveOutAScanThatIsOld) {
    EXPECT_THAT(joined({{1, 0.9}, {0, 1.0}, {0, 1.2}}), ElementsAre(ElementsAre(10, 9), ElementsAre(12)));
}

TEST(JoinedScans, GoOnWithAnotherLidarWhileTheFirstIsSilent) {
    EXPECT_THAT(joined({{0, 1.0}, {1, 1.9}, {1, 2.1}, {1, 2.2}, {0, 2.3}, {1, 2.4}, {0, 2.5}}),
                ElementsAre(ElementsAre(10), ElementsAre(21), ElementsAre(22), ElementsAre(23), ElementsAre(25, 24)));
    EXPECT_THAT(joined({{1, 1.0}, {1, 1.5}, {1, 2.5}}), ElementsAre(ElementsAre(25)));
    EXPECT_THAT(joined({}), IsEmpty());
}

/// A lidar that sees one wall of three points.
SensorFrame seen_from(const Pose2& robot_from_laser, const Pose2& odom_from_robot) {
    SensorFrame frame;
    frame.scan.angle_min_rad = -0.1;
    frame.scan.angle_increment_rad = 0.1;
    frame.scan.ranges_m = {2.0F, 2.0F, 2.0F};
    frame.robot_from_laser = robot_from_laser;
    frame.odom_from_robot = odom_from_robot;
    return frame;
}

TEST(JoinedScanPoints, AreWhereTheRobotWasWhenTheOtherScanWasTaken) {
    SensorFrame frame = seen_from({0.5, 0.0, 0.0}, {1.0, 1.0, 0.0});
    frame.joined.push_back(seen_from({-0.5, 0.0, std::numbers::pi}, {1.0, 0.8, std::numbers::pi / 2}));
    const ScanPoints points = scan_points(frame, {});
    ASSERT_EQ(points.size(), 6U);
    ASSERT_EQ(points.joined.size(), 1U);
    EXPECT_EQ(points.joined[0].begin, 3U);
    // The robot was 0.2 m to the right and looked left, so that its rear lidar was behind it, on the right.
    EXPECT_NEAR(points.joined[0].origin_m.x_m, 0.0, 1e-9);
    EXPECT_NEAR(points.joined[0].origin_m.y_m, -0.7, 1e-9);
    EXPECT_NEAR(points.x_m[4], 0.0, 1e-6);
    EXPECT_NEAR(points.y_m[4], -2.7, 1e-6);
    EXPECT_NEAR(std::abs(points.normal_y[4]), 1.0, 1e-3);
    EXPECT_GT(points.order[3] - points.order[2], 2);
    EXPECT_EQ(points.order[4] - points.order[3], 1);
}

TEST(JoinedScanPoints, AreThoseOfTheOtherScanWhereTheOwnHasNone) {
    SensorFrame frame = seen_from({}, {});
    frame.scan.ranges_m.assign(3, LaserScan::invalid);
    frame.joined.push_back(seen_from({0.1, 0.2, 0.0}, {}));
    const ScanPoints points = scan_points(frame, {});
    EXPECT_EQ(points.size(), 3U);
    EXPECT_EQ(points.joined.at(0).begin, 0U);
}

}  // namespace
}  // namespace ddtool

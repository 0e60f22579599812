#include "logs/stream/frame_watch.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace ddtool {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Frames at 5 Hz of a robot that drives along x in front of walls that its lidar sees; the odometry may say otherwise.
class Watched : public testing::Test {
protected:
    void frame(double odom_x_m, double true_x_m, OdometryStep step = OdometryStep::measured) {
        SensorFrame frame;
        frame.scan.stamp_ns = std::llround(1e9 * now_s_);
        for (int beam = 0; beam < 20; ++beam) {
            frame.scan.ranges_m.push_back(static_cast<float>(20.0 - true_x_m + 0.1 * beam));
        }
        frame.odom_from_robot.x_m = odom_x_m;
        frame.odom_step = step;
        watch_.add(frame);
        now_s_ += 0.2;
        take();
    }
    void take() {
        for (auto frame = watch_.take(); frame; frame = watch_.take()) {
            taken_.push_back(*frame);
        }
        for (std::string& finding : watch_.take_findings()) {
            findings_.push_back(std::move(finding));
        }
    }
    void end() {
        watch_.end();
        take();
    }
    std::vector<std::size_t> unknown() const {
        std::vector<std::size_t> numbers;
        for (std::size_t i = 0; i < taken_.size(); ++i) {
            if (taken_[i].odom_step == OdometryStep::unknown) {
                numbers.push_back(i);
            }
        }
        return numbers;
    }

    FrameWatch watch_;
    double now_s_ = 100.0;
    std::vector<SensorFrame> taken_;
    std::vector<std::string> findings_;
};

TEST_F(Watched, OfADrivingRobotNoFrameWaitsAndStuckOdometryIsStillSeen) {
    watch_ = FrameWatch(0);
    for (int i = 0; i < 60; ++i) {
        frame(5.0, 0.1 * i);
        EXPECT_EQ(taken_.size(), static_cast<std::size_t>(i) + 1);
    }
    EXPECT_EQ(taken_.back().odom_step, OdometryStep::unknown);
    end();
    EXPECT_THAT(findings_, ElementsAre(HasSubstr("the odometry is stuck")));
}

TEST_F(Watched, WhatAgreesPassesAtOnce) {
    for (int i = 0; i < 20; ++i) {
        frame(0.1 * i, 0.1 * i);
        EXPECT_EQ(taken_.size(), static_cast<std::size_t>(i) + 1);
    }
    end();
    EXPECT_THAT(unknown(), IsEmpty());
    EXPECT_THAT(findings_, IsEmpty());
}

TEST_F(Watched, OdometryThatIsStuckForAPartIsUnknownThere) {
    for (int i = 0; i < 30; ++i) {
        frame(0.1 * (i < 10 ? i : (i < 20 ? 9 : i)), 0.1 * i);
    }
    end();
    ASSERT_EQ(taken_.size(), 30U);
    EXPECT_THAT(unknown(), ElementsAre(10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20)) << "the step out of it, too";
    EXPECT_THAT(findings_, ElementsAre(HasSubstr("stuck from 1.8 s to 4.0 s (10 scans)")));
}

TEST_F(Watched, AStampFarFromItsNeighboursIsSaidAtTheEnd) {
    for (int i = 0; i < 20; ++i) {
        now_s_ = 100.0 + 0.2 * i + (i == 10 ? 1e8 : 0.0);
        frame(0.1 * i, 0.1 * i);
    }
    end();
    EXPECT_EQ(taken_.size(), 19U);
    EXPECT_THAT(findings_, ElementsAre(HasSubstr(
                               "1 scan is left out, stamped far away from the scans before and after, number 11, "
                               "3.2 years ahead")));
}

TEST_F(Watched, OdometryThatStaysStuckIsSaidAtTheEnd) {
    for (int i = 0; i < 30; ++i) {
        frame(0.1 * std::min(i, 9), 0.1 * i);
    }
    end();
    EXPECT_EQ(unknown().size(), 20U);
    EXPECT_THAT(findings_, ElementsAre(HasSubstr("stuck from 1.8 s to 5.8 s")));
}

TEST_F(Watched, OdometryThatStopsBeforeItStartsAgainIsUnknownFromThereOn) {
    for (int i = 0; i < 20; ++i) {
        frame(0.1 * (i < 10 ? i : (i < 13 ? 9 : i)), 0.1 * i, i == 13 ? OdometryStep::unknown : OdometryStep::measured);
    }
    end();
    EXPECT_THAT(unknown(), ElementsAre(10, 11, 12, 13));
    EXPECT_THAT(findings_, IsEmpty()) << "the reset has been said";
}

TEST_F(Watched, ARobotThatStandsIsBelieved) {
    for (int i = 0; i < 300; ++i) {
        frame(1.0, i < 150 ? 0.0 : 1.0);  // a door opens
    }
    EXPECT_GE(taken_.size(), 300U - FrameWatch::most_waiting);
    end();
    EXPECT_EQ(taken_.size(), 300U);
    EXPECT_THAT(unknown(), IsEmpty());
    EXPECT_THAT(findings_, IsEmpty());
}

TEST_F(Watched, TwoLidarsThatTakeTurnsAreNotCompared) {
    for (int i = 0; i < 60; ++i) {
        SensorFrame frame;
        frame.scan.stamp_ns = i;
        frame.robot_from_laser.theta_rad = i % 2 == 0 ? 0.0 : 3.0;
        frame.scan.ranges_m.assign(20, i % 2 == 0 ? 2.0F : 5.0F);
        watch_.add(frame);
    }
    end();
    EXPECT_THAT(unknown(), IsEmpty());
}

TEST_F(Watched, ScansThatAreMissingWhileTheRobotMovesAreSaid) {
    for (int i = 0; i < 20; ++i) {
        frame(0.1 * i, 0.1 * i);
    }
    now_s_ += 5.0;
    frame(4.0, 4.0);
    now_s_ += 5.0;
    frame(4.1, 4.1);
    EXPECT_THAT(findings_, ElementsAre(HasSubstr("no scans from 3.8 s to 9.0 s, while the odometry moves by 2.10 m")));
}

}  // namespace
}  // namespace ddtool

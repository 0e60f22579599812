#include "ddtool/filter/failed_match.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ddtool {
namespace {

/// The end points of a scan in the middle of a square room of 4 m.
std::vector<Point2> room_ends() {
    std::vector<Point2> ends;
    for (int step = -39; step <= 39; ++step) {
        const double along_m = 0.05 * step;
        ends.insert(ends.end(), {{2.0, along_m}, {-2.0, along_m}, {along_m, 2.0}, {along_m, -2.0}});
    }
    return ends;
}

/// A scan whose map holds it at the origin.
struct RoomMatch {
    RoomMatch() {
        map.reserve({-3.0, -3.0}, {3.0, 3.0});
        for (const Point2& end : ends) {
            map.add(end);
        }
    }
    HillClimb::Found at(const Pose2& pose) { return {pose, matcher.fit(map, ends, pose)}; }
    HillClimb::Found rescue(const FailedMatchSettings& settings, const Pose2& found, const Pose2& predicted,
                            double degree) {
        return rescued(settings, matcher, map, ends, ends.size(), at(found), predicted, degree);
    }

    std::vector<Point2> ends = room_ends();
    HitMap map{0.05};
    HillClimb matcher{HillClimbSettings{}};
};

const Pose2 right_pose{};
const Pose2 near_pose{0.03, 0.0, 0.0};

TEST(FailedMatch, LeavesAGoodMatchAloneUnlessTheSwarmIsDegenerate) {
    RoomMatch room;
    const FailedMatchSettings settings{.search = std::nullopt, .weighs_odometry = true};
    for (const double degree : {0.0, 0.25, 0.5}) {
        EXPECT_EQ(room.rescue(settings, right_pose, near_pose, degree).pose, right_pose) << degree;
    }
    const HillClimb::Found given_up = room.rescue(settings, right_pose, near_pose, 1.0);
    EXPECT_EQ(given_up.pose, near_pose);
    EXPECT_EQ(given_up.fit.score, room.at(near_pose).fit.score);
    EXPECT_EQ(given_up.fit.log_likelihood, room.at(near_pose).fit.log_likelihood);
}

TEST(FailedMatch, KeepsAMatchOfMuchHigherScoreThanTheOdometryHas) {
    RoomMatch room;
    const FailedMatchSettings settings{.search = std::nullopt, .weighs_odometry = true};
    EXPECT_EQ(room.rescue(settings, right_pose, {0.5, 0.4, 0.3}, 1.0).pose, right_pose);
}

TEST(FailedMatch, WithoutStrategiesKeepsTheMatch) {
    RoomMatch room;
    EXPECT_EQ(room.rescue({}, near_pose, right_pose, 1.0).pose, near_pose);
}

TEST(FailedMatch, SearchesLongerTheMoreDegenerateTheSwarmIs) {
    RoomMatch room;
    const FailedMatchSettings settings{.least_score = 10.0,
                                       .search = CoarseFineSettings{.step_m = 0.1, .turn_rad = 0.05}};
    const Pose2 far{0.4, 0.0, 0.0};
    double before = room.at(far).fit.score;
    for (const double degree : {0.0, 0.5}) {
        const HillClimb::Found found = room.rescue(settings, far, far, degree);
        EXPECT_GT(found.fit.score, before) << degree;
        before = found.fit.score;
    }
    EXPECT_LT(std::hypot(room.rescue(settings, far, far, 1.0).pose.x_m, 0.0), 0.06);
}

TEST(FailedMatch, FailsWhereFewBeamsOfTheScanMeetTheMap) {
    RoomMatch room;
    const FailedMatchSettings settings{.search = std::nullopt, .weighs_odometry = true};
    const HillClimb::Found kept =
        rescued(settings, room.matcher, room.map, room.ends, room.ends.size(), room.at(near_pose), right_pose, 0.5);
    EXPECT_EQ(kept.pose, near_pose);
    const HillClimb::Found failed =
        rescued(settings, room.matcher, room.map, room.ends, 5 * room.ends.size(), room.at(near_pose), right_pose, 0.5);
    EXPECT_EQ(failed.pose, right_pose);
}

}  // namespace
}  // namespace ddtool

#include "ddtool/filter/hill_climb.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <numbers>

#include "ddtool/base/random.hpp"
#include "ddtool/system/settings.hpp"

namespace ddtool {
namespace {

constexpr double reference_cell_m = 0.05;

/// Enters a scan into a map, as the filter does.
void enter(HitMap& map, const std::vector<Point2>& ends, const Pose2& pose) {
    constexpr double reach_m = 20.0;
    map.reserve({pose.x_m - reach_m, pose.y_m - reach_m}, {pose.x_m + reach_m, pose.y_m + reach_m});
    for_each_end(ends, pose, [&](const Point2& end) { map.add(end); });
}

class Reference {
public:
    [[nodiscard]] const Json& list(const char* name) const { return json_.at(name); }

    [[nodiscard]] std::vector<Point2> ends_of(const Json& scan) const {
        std::vector<Point2> ends;
        for (const Json& range : scan.at("ranges_m")) {
            const double angle_rad = (json_.at("angle_min_deg").get<double>() +
                                      static_cast<double>(ends.size()) * json_.at("angle_step_deg").get<double>()) *
                                     std::numbers::pi / 180.0;
            ends.push_back({range.get<double>() * std::cos(angle_rad), range.get<double>() * std::sin(angle_rad)});
        }
        return ends;
    }
    static Pose2 pose_of(const Json& pose) {
        return {pose[0].get<double>(), pose[1].get<double>(), pose[2].get<double>()};
    }
    [[nodiscard]] HitMap map() const {
        HitMap map(reference_cell_m);
        for (const Json& scan : list("mapped")) {
            enter(map, ends_of(scan), pose_of(scan.at("pose")));
        }
        return map;
    }

private:
    Json json_ = Json::parse(std::ifstream(FILTER_TEST_DIR "/gmapping_reference.json"));
};

void expect_fit(const BeamFit& fit, const Json& score, const Json& log_likelihood) {
    EXPECT_NEAR(fit.score / score.get<double>(), 1.0, 1e-9);
    EXPECT_NEAR(fit.log_likelihood / log_likelihood.get<double>(), 1.0, 1e-9);
}

TEST(HillClimb, AnswersAsOpenSlamGmappingDoes) {
    const Reference reference;
    const HitMap map = reference.map();
    HillClimb matcher{HillClimbSettings{}};
    for (const Json& match : reference.list("matches")) {
        const std::vector<Point2> ends = reference.ends_of(match);
        const Pose2 start = Reference::pose_of(match.at("start"));
        expect_fit(matcher.fit(map, ends, start), match.at("start_score"), match.at("start_log_likelihood"));
        const HillClimb::Found found = matcher.climb(map, ends, start);
        const Pose2 expected = Reference::pose_of(match.at("found"));
        EXPECT_NEAR(found.pose.x_m, expected.x_m, 1e-12);
        EXPECT_NEAR(found.pose.y_m, expected.y_m, 1e-12);
        EXPECT_NEAR(found.pose.theta_rad, expected.theta_rad, 1e-12);
        expect_fit(found.fit, match.at("found_score"), match.at("found_log_likelihood"));
    }
}

/// A corner of two walls, seen from the origin.
std::vector<Point2> corner() {
    std::vector<Point2> ends;
    for (int i = 0; i < 40; ++i) {
        ends.push_back({2.0, -1.0 + 0.05 * i});
        ends.push_back({2.0 - 0.05 * i, 1.0});
    }
    return ends;
}

TEST(HillClimb, EndsWhereNoStepScoresMore) {
    HitMap map(reference_cell_m);
    enter(map, corner(), {});
    const HillClimbSettings settings;
    HillClimb matcher(settings);
    RandomStream random{3};
    for (int i = 0; i < 20; ++i) {
        const Pose2 start{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1), random.uniform(-0.05, 0.05)};
        const HillClimb::Found found = matcher.climb(map, corner(), start);
        EXPECT_GE(found.fit.score, matcher.fit(map, corner(), start).score);
        const double step_m = settings.step_m * std::pow(0.5, settings.halvings);
        const double turn_rad = settings.turn_rad * std::pow(0.5, settings.halvings);
        for (const Pose2& step : std::array<Pose2, 6>{{{step_m, 0, 0},
                                                       {-step_m, 0, 0},
                                                       {0, step_m, 0},
                                                       {0, -step_m, 0},
                                                       {0, 0, turn_rad},
                                                       {0, 0, -turn_rad}}}) {
            const Pose2 there{found.pose.x_m + step.x_m, found.pose.y_m + step.y_m,
                              found.pose.theta_rad + step.theta_rad};
            EXPECT_LE(matcher.fit(map, corner(), there).score, found.fit.score + 1e-9);
        }
    }
}

TEST(HillClimb, FindsItsWayBackFromNearBy) {
    HitMap map(reference_cell_m);
    enter(map, corner(), {});
    HillClimb matcher{HillClimbSettings{}};
    const Pose2 found = matcher.climb(map, corner(), {0.06, -0.04, 0.02}).pose;
    EXPECT_NEAR(found.x_m, 0.0, 0.01);
    EXPECT_NEAR(found.y_m, 0.0, 0.01);
    EXPECT_NEAR(found.theta_rad, 0.0, 0.01);
}

/// A beam that ends in ground never seen costs .5 / .075 and scores nothing, wherever it ends.
TEST(HillClimb, GroundNeverSeenCostsAsMuchAsAMiss) {
    HitMap map(reference_cell_m);
    enter(map, corner(), {});
    HillClimb matcher{HillClimbSettings{}};
    const std::vector<Point2> unseen{{-3.0, 0.0}, {-50.0, 7.0}};
    const BeamFit fit = matcher.fit(map, unseen, {});
    EXPECT_EQ(fit.score, 0.0);
    EXPECT_DOUBLE_EQ(fit.log_likelihood, -2.0 * 0.5 / 0.075);
    const HillClimb::Found found = matcher.climb(map, unseen, {0.3, 0.2, 0.1});
    EXPECT_EQ(found.pose, (Pose2{0.3, 0.2, 0.1}));
}

/// The wider the score, the more a distant beam counts, up to widths at which the exponential is nearly 0 or 1.
TEST(HillClimb, ScoresTheExponentialOfTheSquaredDistance) {
    HitMap map(reference_cell_m);
    enter(map, {{1.0, 0.0}}, {});
    const double distance_m = 0.03;
    for (const double width_m2 : {1e-6, 1e-4, 0.001, 0.05, 3.0}) {
        HillClimbSettings settings;
        settings.score_width_m2 = width_m2;
        constexpr double mean_m = 1.0;  // in single precision, too
        const double expected = std::exp(-std::pow(mean_m + distance_m - mean_m, 2) / width_m2);
        const double score = HillClimb(settings).fit(map, std::vector<Point2>{{mean_m + distance_m, 0.0}}, {}).score;
        EXPECT_NEAR(score, expected, 1e-12 * expected) << width_m2;
    }
}

TEST(BeamFit, HasAMeanScoreWithoutBeamsToo) {
    EXPECT_EQ(BeamFit{}.mean_score(), 0.0);
    EXPECT_EQ((BeamFit{.score = 3.0, .log_likelihood = 0.0, .beams = 4}.mean_score()), 0.75);
}

}  // namespace
}  // namespace ddtool
